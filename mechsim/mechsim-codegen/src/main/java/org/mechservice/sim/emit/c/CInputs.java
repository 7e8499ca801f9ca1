package org.mechservice.sim.emit.c;

import java.util.List;

/**
 * Inputs of a model in C: loads that stand for forces written as classes.
 *
 * @param variables the inputs in order
 * @param places index of each among the loads, which the programs read behind the parameters
 * @param loads number of loads; those that are no input are zero
 */
public record CInputs(List<CVariable> variables, List<Integer> places, int loads) {
  /** No inputs. */
  public static final CInputs NONE = new CInputs(List.of(), List.of(), 0);

  public CInputs {
    variables = List.copyOf(variables);
    places = List.copyOf(places);
  }
}
