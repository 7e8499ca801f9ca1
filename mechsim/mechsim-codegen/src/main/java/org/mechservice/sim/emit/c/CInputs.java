package org.mechservice.sim.emit.c;

import java.util.List;

/**
 * Inputs of a model in C: those of its file, and loads that stand for forces written as classes.
 * The programs read them behind the tunable parameters.
 *
 * @param variables the inputs in order
 * @param places place of each behind the tunable parameters
 * @param parameters number of the last of the mechanism's parameters that are inputs
 * @param loads number of loads, behind these; those that are no input are zero
 */
public record CInputs(List<CVariable> variables, List<Integer> places, int parameters, int loads) {
  public CInputs {
    variables = List.copyOf(variables);
    places = List.copyOf(places);
  }
}
