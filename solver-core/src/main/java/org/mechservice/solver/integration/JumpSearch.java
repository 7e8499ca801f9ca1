package org.mechservice.solver.integration;

/**
 * Narrows down a place at which the right-hand side seems to jump.
 *
 * <p>Left alone, an Adams method meets an undeclared jump again and again: its steps grow on the
 * near side, run into it, and are halved many times over. Two tries in a row of failures that miss
 * the tolerance by far are taken for a jump somewhere before the end of the shorter one. From then
 * on the stretch in which it must lie is halved at every try, whether that is accepted or rejected,
 * until a step of order 1 over all of it would pass; after some failures in a row, at the geometric
 * mean of all of it and of that step. Behind the jump the history is of no use.
 */
final class JumpSearch {
  /** Error over the tolerance that a step of a smooth problem hardly ever has. */
  private static final double FAR_OFF = 100;

  /** Error planned for the step across, over the tolerance. */
  private static final double AIM = 0.5;

  /** After this many failures in a row the jump is looked for right ahead. */
  private static final int MANY_IN_A_ROW = 4;

  private int failures;
  private int inARow;
  private boolean crossing;

  /** A place behind the jump, and the size of the jump in units of the error allowed. */
  private double behind;

  private double jump;

  void clear() {
    failures = 0;
    inARow = 0;
    crossing = false;
    behind = Double.NaN;
  }

  /** Returns whether a jump is being narrowed down. */
  boolean active() {
    return failures >= 2;
  }

  /**
   * Takes note of a step that failed the error test.
   *
   * @param end where it would have ended
   * @param error over the tolerance
   * @param discrepancy norm of the difference of the right-hand side from its extrapolation
   */
  void rejected(double end, double error, double discrepancy) {
    if (!active() && !(error >= FAR_OFF)) {
      return;
    }
    failures++;
    inARow++;
    crossing = false;
    behind = end;
    jump = discrepancy;
  }

  /**
   * Returns whether a step that passes the error test has the jump inside all the same: formulas of
   * high order think little of a single value that is off.
   *
   * @param h its size
   */
  boolean inside(double h, double discrepancy) {
    return active() && errorAcross(h, discrepancy) > 1;
  }

  /** Error of a step of order 1 across a jump, over the tolerance. */
  private static double errorAcross(double h, double jump) {
    return 0.5 * Math.abs(h) * jump;
  }

  /**
   * Takes note of an accepted step.
   *
   * @param end where it ends
   * @param direction 1 forwards, −1 backwards
   * @return whether a jump that was narrowed down lies behind it
   */
  boolean accepted(double end, double direction) {
    inARow = 0;
    if (failures == 0 || !(direction * (end - behind) >= 0)) {
      return false;
    }
    boolean crossed = active();
    clear();
    return crossed;
  }

  /** Returns the step to try from {@code t}, signed; of order 1 if {@link #crossing}. */
  double step(double t) {
    double stretch = behind - t;
    double error = errorAcross(stretch, jump);
    crossing = error <= AIM;
    if (crossing) {
      return stretch;
    }
    return inARow < MANY_IN_A_ROW ? 0.5 * stretch : stretch * Math.sqrt(AIM / error);
  }

  /** Returns whether the step to try goes across the jump. */
  boolean crossing() {
    return crossing;
  }

  /** Carries the state between two steps over. */
  void transfer(StateTransfer state) {
    failures = state.integer(failures);
    inARow = state.integer(inARow);
    crossing = state.flag(crossing);
    behind = state.number(behind);
    jump = state.number(jump);
  }
}
