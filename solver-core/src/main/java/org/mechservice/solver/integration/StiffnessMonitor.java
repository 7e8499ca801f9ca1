package org.mechservice.solver.integration;

/**
 * Suspects stiffness as DE does: in a stiff problem stability, not accuracy, limits the step of an
 * Adams method, and low orders have the larger regions of stability. The verdict falls every 500
 * steps: whether 50 in a row among them used order 4 or less. Shampine and Gordon 1975, ch. 8.
 *
 * <p>Beyond the original, such a row counts only if its errors came near the tolerance: where they
 * do not, it is the user's bound on the step or a solution at rest that keeps the order low.
 */
final class StiffnessMonitor {
  private static final int STEPS_PER_VERDICT = 500;
  private static final int LOW_ORDER_STEPS = 50;
  private static final int LOW_ORDER = 4;

  /** Error, over the tolerance, that a step limited by stability reaches now and then. */
  private static final double NOTICEABLE_ERROR = 0.01;

  private int steps;
  private int lowOrderSteps;
  private double largestError;
  private boolean suspected;
  private boolean verdict;

  void clear() {
    beginCount();
    verdict = false;
  }

  /** Takes note that the history was forgotten: order and step start low anew. */
  void beginAgain() {
    beginCount();
  }

  /**
   * Takes note of an accepted step.
   *
   * @param order its order
   * @param error its error over the tolerance
   */
  void record(int order, double error) {
    steps++;
    lowOrderSteps = order > LOW_ORDER ? 0 : lowOrderSteps + 1;
    largestError = order > LOW_ORDER ? 0 : Math.max(largestError, error);
    suspected |= lowOrderSteps >= LOW_ORDER_STEPS && largestError >= NOTICEABLE_ERROR;
    if (steps == STEPS_PER_VERDICT) {
      verdict |= suspected;
      beginCount();
    }
  }

  private void beginCount() {
    steps = 0;
    lowOrderSteps = 0;
    largestError = 0;
    suspected = false;
  }

  /** Returns whether any verdict since the start was stiff. */
  boolean suspectsStiffness() {
    return verdict;
  }

  /** Carries the state between two steps over. */
  void transfer(StateTransfer state) {
    steps = state.integer(steps);
    lowOrderSteps = state.integer(lowOrderSteps);
    largestError = state.number(largestError);
    suspected = state.flag(suspected);
    verdict = state.flag(verdict);
  }
}
