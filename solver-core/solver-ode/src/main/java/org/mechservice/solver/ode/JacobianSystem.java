package org.mechservice.solver.ode;

/** An initial value problem that knows the Jacobian of its right-hand side. */
public interface JacobianSystem extends OdeSystem {
  /**
   * Evaluates ∂f/∂y.
   *
   * @param t independent variable
   * @param y unknowns; not modified
   * @param fy ∂f_i/∂y_j at i n + j, or for a {@link BandedSystem} or {@link BlockSystem} at the
   *     place of its band or block; all zero when handed in, elements that are zero need not be
   *     written
   */
  void jacobian(double t, double[] y, double[] fy);
}
