package org.mechservice.solver.ode.adams;

import java.util.Arrays;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.step.ErrorNorm;

/**
 * Suspects stiffness: that stability, not accuracy, limits the step of an Adams method.
 *
 * <p>The two evaluations of a step, at the prediction p and at the corrected y, tell how fast f
 * changes: h L = h ‖f(y) − f(p)‖ / ‖y − p‖, at no cost, and whether it acts against the change, by
 * the cosine of the angle between both vectors. A method is at the limit of its stability if h L is
 * near 1, or, with formulas of high order, from 0.35 on if the change is damped; an oscillation
 * that is merely resolved is not damped and stays below. The verdict is stiff as soon as 30 of the
 * last 50 steps were at that limit. Shampine, <i>Lipschitz constants and robust ODE codes</i>,
 * 1980.
 *
 * <p>The verdict of Shampine and Gordon 1975, ch. 8, counts too: 50 steps in a row with order 4 or
 * less, looked for every 500 steps. Beyond the original, such a row counts only if its errors came
 * near the tolerance: where they do not, it is the user's bound on the step or a solution at rest
 * that keeps the order low.
 */
public final class StiffnessMonitor {
  private static final int WINDOW = 50;
  private static final int AT_THE_LIMIT = 30;

  /** Steps, and those at the limit among them, that tell enough to try another method. */
  private static final int LATEST = 16;

  private static final int LATEST_AT_THE_LIMIT = 13;

  /** h L at the limit of stability, whatever the direction, and along damped directions. */
  private static final double LIMIT = 0.8;

  private static final double LIMIT_DAMPED = 0.35;
  private static final double DAMPED = -0.6;

  /** Steps in a row below the edge of stability after which it is left. */
  private static final int OFF_THE_EDGE = 16;

  private static final int STEPS_PER_VERDICT = 500;
  private static final int LOW_ORDER_STEPS = 50;
  private static final int LOW_ORDER = 4;

  /** Error, over the tolerance, that a step limited by stability reaches now and then. */
  private static final double NOTICEABLE_ERROR = 0.01;

  /** Whether each of the last steps was at the limit; a ring. */
  private final boolean[] limited = new boolean[WINDOW];

  private int slot;
  private int limitedSteps;
  private int latestLimitedSteps;

  /**
   * Part of the derivative below which its change between prediction and correction may be
   * rounding: steps at the start are so short that nothing moves by more.
   */
  private static final double ROUNDING = 1e-9;

  /** ‖h (f(y) − f(p))‖², ‖y − p‖², ‖h f‖² of the latest step but for its factors, and g_{k+1}. */
  private double latestReaction;

  private double latestCorrection;
  private double latestWhole;
  private double latestG;

  private int steps;
  private int lowOrderSteps;
  private double largestError;
  private boolean suspected;
  private boolean verdict;

  /** Steps with h L at the edge along no damped direction, and those since. */
  private long stepsAtEdge;

  /** Size of the fastest motion where they began, in errors allowed; it may be less. */
  private double sizeAtEdge;

  private int stepsOffEdge;

  void clear() {
    beginAgain();
    verdict = false;
  }

  /** Takes note that the history was forgotten: order and step start low anew. */
  void beginAgain() {
    Arrays.fill(limited, false);
    slot = 0;
    limitedSteps = 0;
    latestLimitedSteps = 0;
    leaveEdge();
    beginCount();
  }

  /**
   * Takes note of an accepted step of order k. With d the discrepancy, y − p = h g_{k+1} d and f(y)
   * − f(p) = φ_{k+1} − d, so that h L = ‖φ_{k+1} − d‖ / (g_{k+1} ‖d‖). Multiplied by about h, the
   * terms are of the size of the error, whatever the units are.
   *
   * @param h its size
   * @param error its error over the tolerance
   * @param g g_{k+1}
   * @param history after the step
   */
  void accepted(double h, int k, double error, double g, AdamsHistory history, ErrorNorm norm) {
    double unit = Math.scalb(1.0, Math.getExponent(h));
    double[] change = history.difference(k + 1);
    double[] discrepancy = history.discrepancy;
    double product = 0;
    double correction = 0;
    double reaction = 0;
    double whole = 0;
    for (int l = 0; l < change.length; l++) {
      double weight = unit * norm.weight(l);
      double moved = weight * discrepancy[l];
      double answer = weight * (change[l] - discrepancy[l]);
      product += moved * answer;
      correction += moved * moved;
      reaction += answer * answer;
      double derivative = weight * history.derivative[l];
      whole += derivative * derivative;
    }
    latestReaction = reaction;
    latestCorrection = correction;
    latestWhole = whole;
    latestG = g;
    double edge = LIMIT_DAMPED * g;
    if (reaction < edge * edge * correction) {
      lookAtEdge(false, 0);
      lookAtLimit(false);
    } else {
      double hL = Math.sqrt(reaction / correction) / g;
      double cosine = product / Math.sqrt(reaction * correction);
      boolean damped = cosine <= DAMPED;
      lookAtEdge(hL >= LIMIT_DAMPED && cosine > DAMPED, Math.abs(h) / unit * Math.sqrt(whole) / hL);
      lookAtLimit(hL >= LIMIT || (hL >= LIMIT_DAMPED && damped));
    }
    count(k, error);
  }

  private void count(int order, double error) {
    steps++;
    lowOrderSteps = order > LOW_ORDER ? 0 : lowOrderSteps + 1;
    largestError = order > LOW_ORDER ? 0 : Math.max(largestError, error);
    suspected |= lowOrderSteps >= LOW_ORDER_STEPS && largestError >= NOTICEABLE_ERROR;
    if (steps == STEPS_PER_VERDICT) {
      verdict |= suspected;
      beginCount();
    }
  }

  private void lookAtEdge(boolean atEdge, double size) {
    if (atEdge) {
      sizeAtEdge = stepsAtEdge == 0 ? size : sizeAtEdge;
      stepsAtEdge++;
      stepsOffEdge = 0;
    } else if (++stepsOffEdge >= OFF_THE_EDGE) {
      leaveEdge();
    }
  }

  private void leaveEdge() {
    stepsAtEdge = 0;
    sizeAtEdge = 0;
    stepsOffEdge = 0;
  }

  private void lookAtLimit(boolean atLimit) {
    int entering = atLimit ? 1 : 0;
    int leavingLatest = (slot + WINDOW - LATEST) % WINDOW;
    latestLimitedSteps += entering - (limited[leavingLatest] ? 1 : 0);
    limitedSteps += entering - (limited[slot] ? 1 : 0);
    limited[slot] = atLimit;
    slot = (slot + 1) % WINDOW;
    verdict |= limitedSteps >= AT_THE_LIMIT;
  }

  private void beginCount() {
    steps = 0;
    lowOrderSteps = 0;
    largestError = 0;
    suspected = false;
  }

  /**
   * Returns whether the latest steps were at the limit of stability: 13 of 16, sooner than a
   * verdict. Of the problems of the suite that are not stiff none has more than 7.
   */
  boolean nowAtStabilityLimit() {
    return latestLimitedSteps >= LATEST_AT_THE_LIMIT;
  }

  /** Returns whether any of the latest steps was at the limit of stability. */
  boolean nearStabilityLimit() {
    return latestLimitedSteps > 0;
  }

  /**
   * Returns how many steps had h L of 0.35 and more along a direction that is not damped, since 16
   * in a row had not.
   */
  long stepsAtEdge() {
    return stepsAtEdge;
  }

  /**
   * Returns how large the motion followed in these steps was at the first of them at most, over the
   * error allowed: ‖f‖ / L.
   */
  double sizeAtEdge() {
    return sizeAtEdge;
  }

  /** Returns h L of the latest step; zero if rounding may have made it. */
  double latestProduct() {
    boolean rounding = !(latestReaction > ROUNDING * ROUNDING * latestWhole);
    return rounding ? 0 : Math.sqrt(latestReaction / latestCorrection) / latestG;
  }

  /** Returns whether any verdict since the start was stiff. */
  boolean suspectsStiffness() {
    return verdict;
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    for (int i = 0; i < WINDOW; i++) {
      limited[i] = state.flag(limited[i]);
    }
    slot = state.integer(slot);
    limitedSteps = state.integer(limitedSteps);
    latestLimitedSteps = state.integer(latestLimitedSteps);
    steps = state.integer(steps);
    lowOrderSteps = state.integer(lowOrderSteps);
    largestError = state.number(largestError);
    suspected = state.flag(suspected);
    verdict = state.flag(verdict);
    stepsAtEdge = state.integer(stepsAtEdge);
    stepsOffEdge = state.integer(stepsOffEdge);
    sizeAtEdge = state.number(sizeAtEdge);
  }
}
