package org.mechservice.solver.ode.backward;

import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.step.ErrorNorm;

/**
 * Error estimates of a stiff step and what follows from them: order and size of the next.
 *
 * <p>The error of order k, in units of the tolerance, is C_k ‖∇^{k+1} y_{n+1}‖; it passes if at
 * most 1. The step for order k that would just pass is h / error^{1/(k+1)}, less a safety factor;
 * since a change costs a factorisation and spoils the differences, step and order stay as they are
 * for at least k + 2 steps, and longer unless a longer step is to be had. Shampine and Reichelt
 * 1997, §2; the safety factors are those of the program described there.
 *
 * <p>Near the imaginary axis the formulas of high order are not stable, which shows in differences
 * that grow with their order. If asked to heed that, the order is lowered at once and not raised as
 * long as it lasts. Only differences of equal steps tell: for some steps after a change of size
 * those of a strongly damped system hold what the change has stirred up.
 *
 * <p>Where the rate and the damping of the fastest oscillation are known, that is known beforehand:
 * no step of orders 3 to 5 is proposed at which the formula makes it grow, see {@link
 * UnstableSteps}, nor tried after a failure: it would go on until the growth fails, and then begin
 * anew from far shorter steps. Where only that, and not accuracy, keeps the step of a higher order
 * short, order 2, which is stable at any step, is taken if it allows a longer one.
 *
 * <p>If asked to be cautious, the step is proposed for 6 times the error, at order k + 1 for 10
 * times, as CVODE does: the errors of the differences after a change add to those of the formula.
 * Hindmarsh et al. 2005, <i>SUNDIALS</i>, ACM TOMS 31, 363, §2.1.
 *
 * <p>At order 1 such a system can be caught: its velocities err by a part of each step, far beyond
 * their tolerances where they are small, which no test sees as long as the steps are equal, and any
 * other step fails. After a growth that failed at once, a program that heeds such things prefers
 * order 2 to a longer step, and stays there until a growth has passed.
 */
public final class BackwardOrderControl {
  /** Safety factors of a step after an accepted one, by change of order. */
  private static final double SAFETY_BELOW = 1.3;

  private static final double SAFETY_SAME = 1.2;
  private static final double SAFETY_ABOVE = 1.4;

  /**
   * Errors for which a step is proposed, over the estimated one, if asked to be cautious. Measured
   * on 14 stiff problems: fewer rejections, 0.96 of the evaluations at equal errors on the mean;
   * half of them on a servo whose steps used to grow and fail in turn.
   */
  private static final double BIAS = 6;

  private static final double BIAS_ABOVE = 10;

  private static final double LARGEST_GROWTH = 10;

  /** Shares of the step that would just pass, after the first failure of a step. */
  private static final double RETRY_SAME = 0.833;

  private static final double RETRY_BELOW = 0.769;
  private static final double SMALLEST_RETRY = 0.1;

  private static final double RETRY_AGAIN = 0.5;

  /** Sizes of a step whose order was lowered because the differences grow. */
  private static final double SMALLEST_LOWERED = 0.5;

  private static final double GROWTH_AT_ORDER_2 = 2;

  /**
   * Part of the step from which on the fastest oscillation grows: at the whole one it would live on
   * as it is, and keep order 2 from going beyond. Parts from 0.9 to 0.98 do alike.
   */
  private static final double DECAYING = 0.95;

  /** Highest order that is stable for every damped oscillation. */
  private static final int ALWAYS_STABLE = 2;

  private final boolean heedsGrowth;
  private BackwardFormulas formulas;
  private boolean cautious;
  private int highestOrder;
  private boolean rising;
  private int order;
  private int equalSteps;
  private boolean failedBefore;

  /** Whether the step was made longer before the present try. */
  private boolean grown;

  /** Whether the last longer step failed its first try, if that is heeded. */
  private boolean caught;

  private double error;

  /** h |λ| of the fastest motion in the step tried last, and its damping ratio; 0 if none. */
  private double fastest;

  private double damping;

  /**
   * @param heedsGrowth whether differences that grow with their order lower it
   */
  public BackwardOrderControl(BackwardFormulas formulas, boolean heedsGrowth) {
    this.formulas = formulas;
    this.heedsGrowth = heedsGrowth;
  }

  /**
   * Begins with order 1.
   *
   * @param rising whether to go on to order 2 when both would let the step grow as much as it may
   */
  public void begin(int highestOrder, boolean rising) {
    this.highestOrder = highestOrder;
    this.rising = rising;
    order = 1;
    equalSteps = 0;
    failedBefore = false;
    grown = false;
    caught = false;
    error = 0;
  }

  /** Returns the order k to use. */
  public int order() {
    return order;
  }

  /** Returns the error estimated last. */
  public double error() {
    return error;
  }

  /** Takes steps shorter than the published program does, by {@link #BIAS}, or not. */
  public void cautious(boolean shorter) {
    cautious = shorter;
  }

  /** Goes on with other formulas. */
  public void use(BackwardFormulas others) {
    formulas = others;
  }

  /**
   * Heeds a damped oscillation from now on.
   *
   * @param fastest h |λ| of it in the step tried last
   * @param dampingRatio of it; 0 if there is none
   */
  public void follow(double fastest, double dampingRatio) {
    this.fastest = fastest;
    damping = dampingRatio;
  }

  /** Begins a step. */
  public void beginStep() {
    failedBefore = false;
  }

  /** Takes note that size or order has changed. */
  public void rescaled() {
    equalSteps = 0;
  }

  /**
   * Estimates the error.
   *
   * @param correction norm of that of the step, or of the part of it that is an error
   */
  public void estimate(double correction) {
    error = formulas.errorConstant(order) * correction;
  }

  /** Goes on with order 1: what lies further back is of no use. */
  public void restart() {
    order = 1;
    equalSteps = 0;
    caught = false;
  }

  /** Chooses the order after a failed error test and returns the factor for the step. */
  public double reject(BackwardDifferences differences, ErrorNorm norm) {
    if (failedBefore) {
      return RETRY_AGAIN;
    }
    failedBefore = true;
    caught |= heedsGrowth && grown;
    double factor = Math.max(SMALLEST_RETRY, RETRY_SAME * passing(error, order));
    double below = mayFall() ? retryBelow(differences, norm) : 0;
    if (below > factor) {
      order--;
      return below;
    }
    return factor;
  }

  /** Returns the factor for the order below; 0 if its error is larger, and its step the shorter. */
  private double retryBelow(BackwardDifferences differences, ErrorNorm norm) {
    int below = order - 1;
    double correction = norm.ofSum(differences.tried(order), differences.correction);
    double errorBelow = formulas.errorConstant(below) * correction;
    if (errorBelow >= error) {
      return 0;
    }
    double retry = Math.min(1, RETRY_BELOW * passing(errorBelow, below));
    return Math.max(SMALLEST_RETRY, outsideUnstable(retry, below));
  }

  /** Chooses the order after an accepted step and returns the factor for the step. */
  public double accept(BackwardDifferences differences, ErrorNorm norm) {
    int k = order;
    caught &= failedBefore || !grown;
    grown = false;
    if (heedsGrowth && mayFall() && equalSteps == k + 2 && differencesGrow(differences, norm)) {
      return lower(k - 1, differences, norm);
    }
    equalSteps = Math.min(equalSteps + 1, k + 2);
    if (equalSteps < k + 2) {
      return 1;
    }
    if (unstable(k)) {
      return leaveUnstable(differences, norm);
    }
    double accurate = growth(error, k, SAFETY_SAME);
    double best = stable(accurate, k);
    if (best < accurate) {
      double atOrder2 =
          growth(errorOf(ALWAYS_STABLE, differences, norm), ALWAYS_STABLE, SAFETY_BELOW);
      if (atOrder2 > best) {
        order = ALWAYS_STABLE;
        grown = true;
        return atOrder2;
      }
    }
    if (mayFall() && !unstable(k - 1)) {
      double below = stable(growth(errorOf(k - 1, differences, norm), k - 1, SAFETY_BELOW), k - 1);
      if (below > best) {
        best = below;
        order = k - 1;
      }
    }
    if (k < highestOrder && !unstable(k + 1) && mayRise(differences, norm)) {
      double above = stable(growth(errorOf(k + 1, differences, norm), k + 1, SAFETY_ABOVE), k + 1);
      if (above > best || ((rising || caught) && k == 1 && above == LARGEST_GROWTH)) {
        best = above;
        order = k + 1;
      }
    }
    grown = best > 1;
    return best;
  }

  /**
   * Returns whether the differences of an accepted step do not fall with their order, as they do
   * where the formula is stable and the solution smooth. Brenan, Campbell and Petzold 1996, ch. 5.
   */
  private boolean differencesGrow(BackwardDifferences differences, ErrorNorm norm) {
    double highest = norm.of(differences.accepted(order + 1));
    double below = norm.of(differences.accepted(order));
    return order == 2
        ? GROWTH_AT_ORDER_2 * below <= highest
        : Math.max(below, norm.of(differences.accepted(order - 1))) <= highest;
  }

  /** Returns whether the formula of order j makes the fastest oscillation grow at this step. */
  private boolean unstable(int j) {
    return damping > 0 && formulas.unstable().contains(j, fastest, damping);
  }

  /** Returns a growth of the step as far as the formula of order j lets that oscillation decay. */
  private double stable(double growth, int j) {
    if (damping == 0 || growth == 1) {
      return growth;
    }
    boolean below = fastest < formulas.unstable().first(j, damping);
    return below ? Math.max(1, Math.min(growth, longestDecaying(j) / fastest)) : growth;
  }

  /**
   * Chooses the order whose longest step is the longest among those that are accurate and let the
   * fastest oscillation decay: the present one with a shorter step, the next, or one of those
   * below.
   */
  private double leaveUnstable(BackwardDifferences differences, ErrorNorm norm) {
    int k = order;
    double best = outsideUnstable(1, k);
    int highest = k < highestOrder && mayRise(differences, norm) ? k + 1 : k;
    for (int j = highest; j >= ALWAYS_STABLE; j--) {
      if (j != k) {
        double bias = j > k ? BIAS_ABOVE : BIAS;
        double accurate = passing(bias * errorOf(j, differences, norm), j);
        double factor = outsideUnstable(Math.min(LARGEST_GROWTH, accurate), j);
        if (factor > best) {
          best = factor;
          order = j;
        }
      }
    }
    grown = best > 1;
    equalSteps = 0;
    return best;
  }

  /** Returns a factor for the step, reduced to where order j lets the fastest oscillation decay. */
  private double outsideUnstable(double factor, int j) {
    return damping > 0 && formulas.unstable().contains(j, factor * fastest, damping)
        ? longestDecaying(j) / fastest
        : factor;
  }

  /** Returns the h |λ| up to which order j lets the fastest oscillation decay visibly. */
  private double longestDecaying(int j) {
    return DECAYING * formulas.unstable().first(j, damping);
  }

  private double lower(int j, BackwardDifferences differences, ErrorNorm norm) {
    double errorBelow = errorOf(j, differences, norm);
    order = j;
    equalSteps = 0;
    double factor = passing(errorBelow, order) / SAFETY_SAME;
    return Math.min(1, Math.max(SMALLEST_LOWERED, factor));
  }

  /** At order 1 an oscillation that is heeded is followed worse, and damped no better. */
  private boolean mayFall() {
    boolean notTo1 = caught || (heedsGrowth && damping > 0);
    return order > (notTo1 ? 2 : 1);
  }

  /** Returns whether the next difference is smaller, or nobody asks. */
  private boolean mayRise(BackwardDifferences differences, ErrorNorm norm) {
    return !heedsGrowth
        || norm.of(differences.accepted(order + 2)) < norm.of(differences.accepted(order + 1));
  }

  /** Error of the accepted step had its order been j. */
  private double errorOf(int j, BackwardDifferences differences, ErrorNorm norm) {
    return formulas.errorConstant(j) * norm.of(differences.accepted(j + 1));
  }

  /** Returns by how much a step of order j may grow; 1 if it may not. */
  private double growth(double error, int j, double safety) {
    if (cautious) {
      double biased = (safety == SAFETY_ABOVE ? BIAS_ABOVE : BIAS) * error;
      return biased < 1 ? Math.min(LARGEST_GROWTH, passing(biased, j)) : 1;
    }
    double enlarged = error;
    for (int i = 0; i <= j; i++) {
      enlarged *= safety;
    }
    if (!(enlarged < 1)) {
      return 1;
    }
    return Math.min(LARGEST_GROWTH, passing(error, j) / safety);
  }

  /** Returns the factor for a step of order j at which its error would be 1, error^(−1/(j+1)). */
  private static double passing(double error, int j) {
    // StrictMath.pow allocates its tables at every call on JDK 17.
    return StrictMath.exp(-StrictMath.log(error) / (j + 1));
  }

  /** Carries the state between two steps over. */
  public void transfer(SavedState state) {
    rising = state.flag(rising);
    order = state.integer(order);
    equalSteps = state.integer(equalSteps);
    rising = state.flag(rising);
    failedBefore = state.flag(failedBefore);
    grown = state.flag(grown);
    caught = state.flag(caught);
    damping = state.number(damping);
    error = state.number(error);
  }
}
