package org.mechservice.solver.ode.solve;

/** Equations in residual form, F(t, y, y') = 0, as a lambda. */
@FunctionalInterface
public interface DaeFunction {
  /**
   * Evaluates F. A value that is not finite says that F is not defined there: the step is then
   * tried shorter.
   *
   * @param t independent variable
   * @param y unknowns, length n; not to be modified
   * @param yDot their derivatives, length n; not to be modified
   * @param residual F(t, y, y'), length n; every component is to be written
   */
  void evaluate(double t, double[] y, double[] yDot, double[] residual);
}
