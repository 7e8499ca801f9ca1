package org.mechservice.solver.ode.jumps;

import org.mechservice.solver.ode.SavedState;

/**
 * Recognises a solution that slides along an undeclared jump by steps that cannot be solved.
 *
 * <p>Where both sides of a jump lead back to it, as dry friction does with a block at rest, the
 * equations of a step that ends near it have no solution. Shorter ones have, so the run goes on in
 * steps that creep and come to nothing.
 */
final class SlidingMonitor {
  /** Unsolved steps after which is looked how close they lie, and those too many for any run. */
  private static final int MANY = 1000;

  private static final double MOST = 1e6;

  private int unsolved;

  /** Time of the first of them. */
  private double since;

  void clear() {
    unsolved = 0;
  }

  /**
   * Takes note of a step that could not be solved with derivatives of its start.
   *
   * @param t time reached
   * @param end of the problem
   * @return whether too many will follow, if they follow as closely as the last ones
   */
  boolean unsolved(double t, double end) {
    if (unsolved++ == 0) {
      since = t;
    }
    if (unsolved < MANY) {
      return false;
    }
    double ahead = unsolved * (end - t) / (t - since);
    unsolved = 0;
    return ahead > MOST;
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    unsolved = state.integer(unsolved);
    since = state.number(since);
  }
}
