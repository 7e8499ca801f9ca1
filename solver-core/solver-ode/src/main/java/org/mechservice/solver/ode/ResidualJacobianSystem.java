package org.mechservice.solver.ode;

/** A problem in residual form that knows the derivatives of its residual. */
public interface ResidualJacobianSystem extends ResidualSystem {
  /**
   * Evaluates ∂F/∂y and ∂F/∂y'. For a {@link CompletedSystem} the former is the derivative along
   * completed states, and only what belongs to independent components is read.
   *
   * @param t where
   * @param y state; not modified
   * @param yDot its derivative; not modified
   * @param fy ∂F_i/∂y_j at i n + j, or for a {@link BandedSystem} at the place of its band; all
   *     zero when handed in, elements that are zero need not be written
   * @param fyDot ∂F_i/∂y'_j, in the same way
   */
  void jacobians(double t, double[] y, double[] yDot, double[] fy, double[] fyDot);
}
