package org.mechservice.solver.ode.solve;

/** A right-hand side, y' = f(t, y), as a lambda. */
@FunctionalInterface
public interface OdeFunction {
  /**
   * Evaluates f. A point at which f is not defined is told by a component of {@code yDot} that is
   * not finite: the step is then tried shorter.
   *
   * @param t independent variable
   * @param y unknowns, length n; not to be modified
   * @param yDot their derivatives, length n; every component is to be written
   */
  void evaluate(double t, double[] y, double[] yDot);
}
