package org.mechservice.solver.ode;

/** An initial value problem's right-hand side, y' = f(t, y). */
public interface OdeSystem extends SystemParts {
  /** Returns the number of unknowns. */
  int dimension();

  /**
   * Evaluates y' = f(t, y). A point at which f is not defined is told by a component of {@code
   * yDot} that is not finite.
   *
   * @param t independent variable
   * @param y unknowns; not modified
   * @param yDot their derivatives; overwritten
   */
  void derivative(double t, double[] y, double[] yDot);
}
