package org.mechservice.solver.api.capability;

import org.mechservice.solver.api.ModelDescription;

/**
 * A model that also has a residual form, F(t, y, y') = 0.
 *
 * <p>The unknowns begin with the state [q; v] of the {@link ModelDescription}; multipliers, if
 * there are any, follow. The explicit form is used at the start and for the output of
 * accelerations.
 */
public interface ResidualModel extends ExplicitModel {
  /** Returns the number of unknowns: states and multipliers. */
  default int unknownCount() {
    return description().stateCount();
  }

  /**
   * Returns whether an unknown's derivative appears in F; error tests leave out the other unknowns.
   */
  default boolean isDifferential(int unknown) {
    return true;
  }

  /**
   * Completes a state to unknowns and derivatives that satisfy the equations.
   *
   * @param t time, s
   * @param y unknowns, length {@link #unknownCount()}; the state is given, multipliers are
   *     overwritten
   * @param yDot their derivatives [N v; v'; 0]; overwritten
   * @return as {@link ExplicitModel#derivative}
   */
  default int consistent(double t, double[] y, double[] yDot) {
    return derivative(t, y, yDot);
  }

  /**
   * Evaluates the residual.
   *
   * @param t time, s
   * @param y unknowns; not modified
   * @param yDot their derivatives; not modified
   * @param residual F(t, y, y'), in the units of q' and of joint forces; overwritten
   * @return {@link ExplicitModel#REGULAR}; {@link Defects#DEFECT} and results of {@link
   *     DirectedForces} as {@link ExplicitModel#derivative}
   */
  int residual(double t, double[] y, double[] yDot, double[] residual);
}
