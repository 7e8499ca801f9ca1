package org.mechservice.solver.ode.jumps;

import org.mechservice.solver.ode.SavedState;

/**
 * Suspects that a solution slides along an undeclared jump in short steps of which many are
 * rejected: both sides of the jump lead back to it, and the steps cross it at every few tries.
 */
final class ChatterMonitor {
  /** Tries after which is looked how far they have come. */
  private static final long MANY = 4096;

  /** Rejected ones among them that are too many. */
  private static final double REJECTED = 0.2;

  /** Tries still to come that are too many for any smooth solution with so many rejections. */
  private static final double MOST = 4e5;

  private long tries;
  private long rejected;
  private double since;

  /** Begins at a place. */
  void begin(double t, long steps, long rejectedSteps) {
    tries = steps + rejectedSteps;
    rejected = rejectedSteps;
    since = t;
  }

  /**
   * Returns whether the tries since this was last answered look like sliding; false as long as they
   * are few.
   *
   * @param t time reached
   * @param end of the problem
   */
  boolean suspects(double t, double end, long steps, long rejectedSteps) {
    long done = steps + rejectedSteps - tries;
    if (done < MANY) {
      return false;
    }
    boolean often = rejectedSteps - rejected >= REJECTED * done;
    boolean endless = done * Math.abs(end - t) > MOST * Math.abs(t - since);
    begin(t, steps, rejectedSteps);
    return often && endless;
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    tries = state.integer(tries);
    rejected = state.integer(rejected);
    since = state.number(since);
  }
}
