package org.mechservice.solver.mechanism;

import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.text.Origin;

/**
 * A state besides positions and velocities, s' = f(t, q, v, s): of a controller, a filter, an
 * actuator.
 *
 * @param name name in the model file
 * @param start value at the start of the run, in the state's own unit
 * @param derivative f, per second; of time, parameters, coordinates, points and further states
 * @param unit unit given by the model's author, {@code 1} if none; values are not converted
 * @param absoluteTolerance tolerance of the error test in that unit; 0 if the run's tolerance for
 *     angles applies
 * @param role where its value comes from
 * @param origin position in the model file
 */
public record FurtherState(
    String name,
    double start,
    Expression derivative,
    String unit,
    double absoluteTolerance,
    Role role,
    Origin origin) {
  /** Creates a state that follows its derivative. */
  public FurtherState(
      String name,
      double start,
      Expression derivative,
      String unit,
      double absoluteTolerance,
      Origin origin) {
    this(name, start, derivative, unit, absoluteTolerance, Role.INTEGRATED, origin);
  }

  /** Returns a state that does not change between the instants at which it is set. */
  public static FurtherState held(
      String name, double start, String unit, Role role, Origin origin) {
    return new FurtherState(name, start, Expression.ZERO, unit, 0, role, origin);
  }

  /** The origin of the value of a state. */
  public enum Role {
    /** From its derivative. */
    INTEGRATED,
    /** From outside of the model, which sets it between two steps of communication. */
    INPUT,
    /** From a {@link Sampling}, which sets it at given times. */
    SAMPLED
  }
}
