package org.mechservice.solver.ode.jumps;

import org.mechservice.solver.ode.SavedState;

/**
 * Recognises undeclared jumps by the way in which error tests fail.
 *
 * <p>Where the derivative jumps, steps that were accurate by far suddenly have to be much shorter:
 * the history is of no use beyond that point, and order 1 goes on without it. Where the solution
 * itself jumps, as that of a differential-algebraic system may, the error is the same however short
 * the step: no step is to blame for it.
 */
final class JumpMonitor {
  /** A step that had less than this of the error allowed was accurate by far. */
  private static final double ACCURATE = 0.1;

  private static final double MUCH_SHORTER = 0.1;

  /** An error that keeps this part of itself, while the step is halved, does not depend on it. */
  private static final double KEPT = 0.7;

  private static final int TIMES_KEPT = 3;

  /** What an error that does not depend on the step may be at most, in units of that allowed. */
  private static final double SMALL_JUMP = 100;

  private double acceptedError;
  private double firstSize;
  private int failures;
  private double lastError;
  private int timesKept;

  /** Begins a problem; the start is no jump. */
  void begin() {
    accepted(Double.MAX_VALUE);
  }

  /** Takes note of an accepted step. */
  void accepted(double error) {
    acceptedError = error;
    failures = 0;
    timesKept = 0;
    lastError = Double.MAX_VALUE;
  }

  /** Takes note of a failed error test. */
  void failed(double h, double error) {
    if (failures == 0) {
      firstSize = Math.abs(h);
    }
    failures++;
    timesKept = error > KEPT * lastError ? timesKept + 1 : 0;
    lastError = error;
  }

  /**
   * Returns whether the derivative seems to have jumped.
   *
   * @param h the step to be tried next
   */
  boolean derivativeJumped(double h) {
    return failures == 2 && Math.abs(h) < MUCH_SHORTER * firstSize && acceptedError < ACCURATE;
  }

  /** Returns whether the solution seems to have jumped, by a number of tolerances. */
  boolean solutionJumped(double error) {
    return timesKept >= TIMES_KEPT && error <= SMALL_JUMP;
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    acceptedError = state.number(acceptedError);
    firstSize = state.number(firstSize);
    failures = state.integer(failures);
    lastError = state.number(lastError);
    timesKept = state.integer(timesKept);
  }
}
