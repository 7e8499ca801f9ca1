package org.mechservice.solver.api;

import org.mechservice.solver.api.result.Variable;

/**
 * A state of a model besides positions and velocities: its name, its unit and its error tolerance.
 *
 * @param name name in the model file and of its column
 * @param unit unit given by the author of the model, {@code 1} if none; values are not converted
 * @param absoluteTolerance tolerance of the error test, in that unit; 0 if the run's tolerance for
 *     angles applies
 */
public record StateVariable(String name, String unit, double absoluteTolerance) {
  /** Returns the column of the state. */
  public Variable variable() {
    return new Variable(name, unit);
  }
}
