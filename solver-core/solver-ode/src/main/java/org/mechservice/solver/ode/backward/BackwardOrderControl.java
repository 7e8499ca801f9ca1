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
 * those of a strongly damped system hold what the change has stirred up. Where the fastest motion
 * is known to be an oscillation, no order and no step is chosen that amplifies it ({@link
 * StabilityRegion}), and none below 2, which follows it worse and damps it no better where steps
 * are as long as its period.
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

  private static final double LARGEST_GROWTH = 10;

  /** Shares of the step that would just pass, after the first failure of a step. */
  private static final double RETRY_SAME = 0.833;

  private static final double RETRY_BELOW = 0.769;
  private static final double SMALLEST_RETRY = 0.1;

  private static final double RETRY_AGAIN = 0.5;

  /** Sizes of a step whose order was lowered because the differences grow. */
  private static final double SMALLEST_LOWERED = 0.5;

  private static final double GROWTH_AT_ORDER_2 = 2;

  /** Damping ratio of an oscillation that does not grow, by a matrix of differences. */
  private static final double LEAST_DAMPING_RATIO = -0.01;

  private final BackwardFormulas formulas;
  private final boolean heedsGrowth;
  private final StabilityRegion region;
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

  /** Whether the fastest motion is an oscillation, and its h λ. */
  private boolean oscillates;

  private double real;
  private double imaginary;

  /**
   * @param heedsGrowth whether differences that grow with their order lower it
   */
  public BackwardOrderControl(BackwardFormulas formulas, boolean heedsGrowth) {
    this.formulas = formulas;
    this.heedsGrowth = heedsGrowth;
    region = new StabilityRegion(formulas);
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
    oscillates = false;
    error = 0;
  }

  /**
   * Takes note of the fastest motion before a step is accepted, if growth is heeded.
   *
   * @param product its rate times the size of the step, h |λ|; not finite if it is not known
   * @param dampingRatio −cos arg λ, below 1 for an oscillation
   */
  public void fastestMotion(double product, double dampingRatio) {
    oscillates =
        heedsGrowth
            && Double.isFinite(product)
            && dampingRatio < 1
            && dampingRatio > LEAST_DAMPING_RATIO;
    if (oscillates) {
      double ratio = Math.max(0, dampingRatio);
      real = -ratio * product;
      imaginary = product * Math.sqrt(1 - ratio * ratio);
    }
  }

  /** Returns the order k to use. */
  public int order() {
    return order;
  }

  /** Returns the error estimated last. */
  public double error() {
    return error;
  }

  /** Begins a step. */
  public void beginStep() {
    failedBefore = false;
  }

  /** Takes note that size or order has changed. */
  public void rescaled() {
    equalSteps = 0;
  }

  /** Estimates the error from the correction. */
  public void estimate(BackwardDifferences differences, ErrorNorm norm) {
    error = formulas.errorConstant(order) * norm.of(differences.correction);
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
    if (mayFall()) {
      double errorBelow =
          formulas.errorConstant(order - 1)
              * norm.ofSum(differences.tried(order), differences.correction);
      double below = Math.max(SMALLEST_RETRY, RETRY_BELOW * passing(errorBelow, order - 1));
      if (below > factor) {
        order--;
        return Math.min(1, below);
      }
    }
    return factor;
  }

  /** Chooses the order after an accepted step and returns the factor for the step. */
  public double accept(BackwardDifferences differences, ErrorNorm norm) {
    int k = order;
    caught &= failedBefore || !grown;
    grown = false;
    if (heedsGrowth && mayFall() && equalSteps == k + 2 && differencesGrow(differences, norm)) {
      return lower(errorOf(k - 1, differences, norm));
    }
    equalSteps = Math.min(equalSteps + 1, k + 2);
    if (equalSteps < k + 2) {
      return 1;
    }
    if (amplifies(k, 1)) {
      return lower(errorOf(k - 1, differences, norm));
    }
    double best = growth(error, k, SAFETY_SAME);
    if (amplifies(k, best)) {
      best = 1;
    }
    if (mayFall()) {
      double below = growth(errorOf(k - 1, differences, norm), k - 1, SAFETY_BELOW);
      if (below > best && !amplifies(k - 1, below)) {
        best = below;
        order = k - 1;
      }
    }
    if (k < highestOrder && mayRise(differences, norm)) {
      double above = growth(errorOf(k + 1, differences, norm), k + 1, SAFETY_ABOVE);
      boolean better = above > best || ((rising || caught) && k == 1 && above == LARGEST_GROWTH);
      if (better && !amplifies(k + 1, above)) {
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

  /** Returns whether a step of order k, longer by a factor, amplifies the fastest motion. */
  private boolean amplifies(int k, double factor) {
    return oscillates && k > 2 && region.amplifies(k, factor * real, factor * imaginary);
  }

  private double lower(double errorBelow) {
    order--;
    equalSteps = 0;
    double factor = passing(errorBelow, order) / SAFETY_SAME;
    return Math.min(1, Math.max(SMALLEST_LOWERED, factor));
  }

  private boolean mayFall() {
    return order > (caught || oscillates ? 2 : 1);
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
  private static double growth(double error, int j, double safety) {
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
    oscillates = state.flag(oscillates);
    error = state.number(error);
  }
}
