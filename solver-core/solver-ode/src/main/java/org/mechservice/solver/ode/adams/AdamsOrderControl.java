package org.mechservice.solver.ode.adams;

import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.step.ErrorNorm;

/**
 * Error estimates of an Adams step and what follows from them: order and size of the next.
 *
 * <p>Errors are in units of the tolerance. With d the discrepancy of f at the prediction,
 *
 * <pre>
 * error       h (g_k − g_{k+1}) ‖d‖                       tested: of the corrector of order k
 * errorHere   h σ_{k+1} γ*_k ‖d‖                          as if all steps had been equal, order k
 * errorBelow  h σ_k γ*_{k−1} ‖φ^p_k + d‖                  order k − 1
 * errorTwoBelow, errorAbove                               orders k − 2 and k + 1 likewise
 * </pre>
 *
 * The step is kept unless it may double or must shrink, for with equal steps the coefficients keep
 * their values. Shampine and Gordon 1975, ch. 7; Hairer, Nørsett and Wanner I, III.7.
 */
final class AdamsOrderControl {
  /**
   * γ*_0 … γ*_13, the error constants of the Adams-Moulton formulas on equal steps, with the digits
   * that the authors used; exact fractions change step counts slightly.
   */
  private static final double[] GAMMA_STAR = {
    1, 0.5, 0.0833, 0.0417, 0.0264, 0.0188, 0.0143, 0.0114, 0.00936, 0.00789, 0.00679, 0.00592,
    0.00524, 0.00468
  };

  /** Error that a step is planned for; the other half of the tolerance is reserve. */
  private static final double AIM = 0.5;

  private static final double LEAST_SHRINKING = 0.9;
  private static final double MOST_SHRINKING = 0.5;

  /** Powers of the least shrinking: errors of high order ask for no more, without a root. */
  private static final double[] LEAST_SHRINKING_RAISED = new double[GAMMA_STAR.length];

  static {
    for (int i = 0; i < LEAST_SHRINKING_RAISED.length; i++) {
      LEAST_SHRINKING_RAISED[i] = StrictMath.pow(LEAST_SHRINKING, i);
    }
  }

  /** After this many failures of a step the order falls to 1. */
  private static final int FAILURES_BEFORE_RESTART = 3;

  /** Reduction of a step in which something was not finite, or the error too large for a number. */
  private static final double NOT_FINITE_REDUCTION = 0.25;

  private int highestOrder;
  private int order;
  private int orderIfRejected;

  /** Whether order and step still grow at every step, from the start to the first obstacle. */
  private boolean starting;

  private int failures;
  private double error;
  private double errorHere;
  private double errorBelow;
  private double discrepancy;

  /** Begins a problem with order 1. */
  void begin(int highestOrder) {
    this.highestOrder = highestOrder;
    order = 1;
    orderIfRejected = 1;
    starting = true;
    failures = 0;
    error = 0;
    errorHere = 0;
    errorBelow = 0;
    discrepancy = 0;
  }

  /** Goes back to order 1 for the step being tried. */
  void fallToOrderOne() {
    order = 1;
    starting = false;
  }

  /** Returns the norm of the discrepancy estimated last. */
  double discrepancy() {
    return discrepancy;
  }

  /** Returns the order k to use. */
  int order() {
    return order;
  }

  /** Returns the error estimated last. */
  double error() {
    return error;
  }

  /** Begins a step. */
  void beginStep() {
    failures = 0;
  }

  /** Estimates the errors of a step of size |h| from the discrepancy. */
  void estimate(double size, AdamsCoefficients c, AdamsHistory history, ErrorNorm norm) {
    int k = order;
    discrepancy = norm.of(history.discrepancy);
    double d = size * discrepancy;
    error = d * (c.g[k] - c.g[k + 1]);
    errorHere = d * c.sigma[k + 1] * GAMMA_STAR[k];
    orderIfRejected = k;
    if (k == 1) {
      return;
    }
    errorBelow = size * c.sigma[k] * GAMMA_STAR[k - 1] * history.discrepancyNorm(norm, k);
    boolean lower =
        k == 2
            ? errorBelow <= 0.5 * errorHere
            : errorBelow <= errorHere && errorTwoBelow(size, c, history, norm) <= errorHere;
    if (lower) {
      orderIfRejected = k - 1;
    }
  }

  /** Takes an error into account that the discrepancy does not show. */
  void include(double other) {
    error = Math.max(error, other);
  }

  private double errorTwoBelow(
      double size, AdamsCoefficients c, AdamsHistory history, ErrorNorm norm) {
    int k = order;
    return size * c.sigma[k - 1] * GAMMA_STAR[k - 2] * history.discrepancyNorm(norm, k - 1);
  }

  /** Chooses the order after a failed error test and returns the factor for the step. */
  double reject() {
    if (!Double.isFinite(error)) {
      return rejectNotFinite();
    }
    recordFailure();
    return failures > FAILURES_BEFORE_RESTART ? Math.min(0.5, Math.sqrt(AIM / errorHere)) : 0.5;
  }

  /** Chooses the order after values that are not finite and returns the factor for the step. */
  double rejectNotFinite() {
    recordFailure();
    return NOT_FINITE_REDUCTION;
  }

  private void recordFailure() {
    failures++;
    starting = false;
    order = failures >= FAILURES_BEFORE_RESTART ? 1 : orderIfRejected;
  }

  /**
   * Chooses order and size of the step after an accepted one.
   *
   * @param size |h| of the accepted step
   * @param equalSteps number of steps of that size, up to this one
   * @return factor for the step
   */
  double accept(double size, int equalSteps, AdamsHistory history, ErrorNorm norm) {
    int k = order;
    if (orderIfRejected == k - 1 || k == highestOrder) {
      starting = false;
    }
    if (starting) {
      order = k + 1;
      return 2;
    }
    if (orderIfRejected == k - 1) {
      lowerOrder();
    } else if (k + 1 <= equalSteps) {
      double errorAbove = size * GAMMA_STAR[k + 1] * norm.of(history.difference(k + 2));
      compareOrders(errorAbove);
    }
    return stepFactor();
  }

  private void compareOrders(double errorAbove) {
    if (order > 1 && errorBelow <= Math.min(errorHere, errorAbove)) {
      lowerOrder();
    } else if (order < highestOrder && errorAbove < (order == 1 ? 0.5 : 1) * errorHere) {
      order++;
      errorHere = errorAbove;
    }
  }

  private void lowerOrder() {
    order--;
    errorHere = errorBelow;
  }

  private double stepFactor() {
    if (Math.scalb(errorHere, order + 1) <= AIM) {
      return 2;
    }
    if (errorHere <= AIM) {
      return 1;
    }
    if (errorHere * LEAST_SHRINKING_RAISED[order + 1] <= AIM) {
      return LEAST_SHRINKING;
    }
    // (AIM / errorHere)^(1/(k+1)); StrictMath.pow allocates its tables at every call on JDK 17.
    double ratio = StrictMath.exp(StrictMath.log(AIM / errorHere) / (order + 1));
    return Math.max(MOST_SHRINKING, Math.min(LEAST_SHRINKING, ratio));
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    order = state.integer(order);
    orderIfRejected = state.integer(orderIfRejected);
    starting = state.flag(starting);
    failures = state.integer(failures);
    error = state.number(error);
    errorHere = state.number(errorHere);
    errorBelow = state.number(errorBelow);
    discrepancy = state.number(discrepancy);
  }
}
