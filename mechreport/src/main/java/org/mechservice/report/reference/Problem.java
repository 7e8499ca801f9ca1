package org.mechservice.report.reference;

/** An initial value problem as the reference codes see it. */
public interface Problem {
  /** Returns the number of unknowns. */
  int dimension();

  /**
   * Evaluates y' = f(t, y).
   *
   * @param y unknowns; not modified
   * @param yDot their derivatives; overwritten
   * @return false if f has no value there
   */
  boolean derivative(double t, double[] y, double[] yDot);

  /**
   * Takes note of the end of a step and moves the state onto the problem's manifold, if it has one.
   *
   * @param y state; components that follow from others are overwritten
   * @return false if it cannot be moved there
   */
  default boolean stepEnded(double t, double[] y) {
    return true;
  }
}
