package org.mechservice.report.reference;

/** An initial value problem for the reference codes. */
public interface Problem {
  /**
   * Returns the number of times, the start among them, that a solution must reach to be of use if
   * its deadline passes; all of them, unless said otherwise.
   */
  default int fewestTimes() {
    return Integer.MAX_VALUE;
  }

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
   * Records the end of a step and projects the state onto the problem's manifold, if it has one.
   *
   * @param y state; components that follow from others are overwritten
   * @return false if it cannot be moved there
   */
  default boolean stepEnded(double t, double[] y) {
    return true;
  }

  /**
   * Returns whether y' depends on a component, which it does not if the component follows from
   * others.
   */
  default boolean matters(int component) {
    return true;
  }

  /** Returns the longest permitted step, in case the problem has short pulses. */
  default double longestStep() {
    return Double.POSITIVE_INFINITY;
  }

  /** Returns the phases of the solution; the same object at every call. */
  default Phases phases() {
    return Phases.NONE;
  }
}
