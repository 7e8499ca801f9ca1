package org.mechservice.solver.api;

/**
 * A model in residual form, F(t, y, y') = 0.
 *
 * <p>The unknowns begin with the state [q; v] of the {@link ModelDescription}; multipliers, if
 * there are any, follow.
 */
public interface ResidualModel extends Model {
  /** Returns the number of unknowns: that of states, and of multipliers. */
  int unknownCount();

  /** Returns whether an unknown's derivative appears in F; if not, it is in no error test. */
  boolean isDifferential(int unknown);

  /**
   * Writes unknowns at the start that fit each other, and their derivatives.
   *
   * @param y length {@link #unknownCount()}; the state as {@link #initialState} gives it,
   *     multipliers; overwritten
   * @param yDot [N v; v'; 0]; overwritten
   * @return {@link ExplicitModel#REGULAR}, the index of a joint, or {@link Defects#DEFECT}, as
   *     {@link ExplicitModel#derivative}
   */
  int initialDerivative(double[] y, double[] yDot);

  /**
   * Evaluates the residual.
   *
   * @param t time, s
   * @param y unknowns; not modified
   * @param yDot their derivatives; not modified
   * @param residual F(t, y, y'), in the units of q' and of joint forces; overwritten
   * @return {@link ExplicitModel#REGULAR} or {@link Defects#DEFECT}
   */
  int residual(double t, double[] y, double[] yDot, double[] residual);
}
