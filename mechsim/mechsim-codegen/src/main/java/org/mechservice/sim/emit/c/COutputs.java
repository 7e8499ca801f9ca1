package org.mechservice.sim.emit.c;

import java.util.List;
import org.mechservice.solver.symbol.Program;

/**
 * Outputs of a model in C that one program computes.
 *
 * @param name name of the function that computes them
 * @param variables the outputs, in the order of the program
 * @param program from time and state to the values
 * @param poses whether they are poses of bodies, whose Euler parameters are put out with e0 ≥ 0
 */
public record COutputs(String name, List<CVariable> variables, Program program, boolean poses) {
  /** Name of the function of kinetic and potential energy, which every model has. */
  public static final String ENERGIES = "energies";
}
