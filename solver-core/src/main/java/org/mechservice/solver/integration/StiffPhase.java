package org.mechservice.solver.integration;

import java.util.Arrays;

/**
 * Judges whether an implicit method still pays: what it has spent over its last 20 steps against
 * what an Adams method would, both in evaluations.
 *
 * <p>An Adams method spends two evaluations a step, and at the limit of its stability a step is 0.8
 * / L long, with L the norm of the Jacobian formed last. The norm is never less than the fastest
 * rate, so that the comparison favours the implicit method, which is at work; evaluations for
 * Jacobians by differences count against it. As long as its steps grow, as they do for a while from
 * its start, it is not judged.
 */
final class StiffPhase {
  private static final int WINDOW = 20;
  private static final double ADAMS_EVALUATIONS = 2;

  /** h L of an Adams step at the limit of its stability. */
  private static final double ADAMS_LIMIT = 0.8;

  /** Cost of the Adams method, relative to the other's, from which on a change pays. */
  private static final double WORTH_A_CHANGE = 0.5;

  /** Ends of the last steps, and evaluations up to there; rings. */
  private final double[] time = new double[WINDOW + 1];

  private final long[] evaluations = new long[WINDOW + 1];
  private int slot;
  private int recorded;

  void begin() {
    Arrays.fill(time, 0);
    Arrays.fill(evaluations, 0);
    slot = 0;
    recorded = 0;
  }

  /** Takes note of a step. */
  void record(double end, long spent) {
    time[slot] = end;
    evaluations[slot] = spent;
    slot = (slot + 1) % time.length;
    recorded = Math.min(recorded + 1, time.length);
  }

  /**
   * Returns whether the last steps could have been had for half their cost.
   *
   * @param fastestRate L
   */
  boolean costsMoreThanAdams(double fastestRate) {
    if (recorded < time.length) {
      return false;
    }
    int latest = (slot + time.length - 1) % time.length;
    if (size(latest - 1) > size(slot)) {
      return false;
    }
    double covered = Math.abs(time[latest] - time[slot]);
    long spent = evaluations[latest] - evaluations[slot];
    return ofAdams(covered, fastestRate) <= WORTH_A_CHANGE * spent;
  }

  /**
   * Returns whether a whole stretch was had for half of what an Adams method would have spent.
   *
   * @param covered length of the stretch, positive
   * @param spent evaluations there
   * @param fastestRate L
   */
  static boolean paid(double covered, long spent, double fastestRate) {
    return spent <= WORTH_A_CHANGE * ofAdams(covered, fastestRate);
  }

  private static double ofAdams(double covered, double fastestRate) {
    return ADAMS_EVALUATIONS * covered * fastestRate / ADAMS_LIMIT;
  }

  /** Returns how long the step after a slot was. */
  private double size(int after) {
    int from = (after + time.length) % time.length;
    return Math.abs(time[(from + 1) % time.length] - time[from]);
  }

  /** Carries the state between two steps over. */
  void transfer(StateTransfer state) {
    state.numbers(time);
    for (int i = 0; i < evaluations.length; i++) {
      evaluations[i] = state.integer(evaluations[i]);
    }
    slot = state.integer(slot);
    recorded = state.integer(recorded);
  }
}
