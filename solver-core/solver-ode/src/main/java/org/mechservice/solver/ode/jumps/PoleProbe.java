package org.mechservice.solver.ode.jumps;

import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.RightHandSide;

/**
 * Looks whether a step goes across a pole: a place where the right-hand side, and the solution with
 * it, grows beyond every bound and comes back with the other or with the same sign.
 *
 * <p>The error test sees values at two ends only. Towards a pole they grow from step to step,
 * behind it they have the other sign, and at loose tolerances a step now and then has an estimate
 * that passes by chance. Where the values look like that, the change of sign is narrowed down. Let
 * w be the width that is left. At a pole A/(t − c) the largest value is A/w at least, and the
 * smaller one at the ends of the whole step is 2A over its length at most, so that value times
 * width never falls below half of what it was; at poles of higher order it grows. Across a jump and
 * through a zero it falls like w, and where the solution stays finite, as with an inverse root,
 * like a power of w.
 *
 * <p>Where the sign stays, the largest value is narrowed down instead, from the place that the
 * values before foretell for A/|t − c| or A/(t − c)². That is done only if the value behind is the
 * one foretold, too: the solution would have changed by more than its own size within the step,
 * which steps of smooth solutions do not pass.
 */
final class PoleProbe {
  /** Part of value times width that is kept at a pole, with room for what else is in f. */
  private static final double KEPT = 0.25;

  /** Halvings that are enough to tell a pole; fewer if no times are left between. */
  private static final int ENOUGH = 40;

  /** Part of its own size by which the solution moves in a step across a pole of constant sign. */
  private static final double MUCH = 0.02;

  /** The same for growth of an order that is not 1 or 2. */
  private static final double VERY_MUCH = 0.1;

  /**
   * Size of a state in tolerances up to which steps across such growth may pass: at tight
   * tolerances none does.
   */
  private static final double MOST_TOLERANCES = 1e5;

  /** How far values may be off where the sign stays, which tells less. */
  private static final double CLOSELY_ALIKE = 1.2;

  private static final double VERY_CLOSELY_ALIKE = 1.15;

  /** How far the values at the two ends may be off those of the pole that the last two foretell. */
  private static final double ALIKE = 2;

  /**
   * Orders of growth that are looked for, the usual ones first. Those between are alike enough: the
   * place foretold is a matter of the order, and the value behind a matter of the place.
   */
  private static final double[] ORDERS = {1, 2, 1.5, 1.25, 1.1, 1.75, 2.5, 3};

  private static final int USUAL = 2;

  /** Derivatives at the beginning of the last step and of the one before it. */
  private double[] before;

  private double[] twoBefore;
  private double timeBefore;
  private double timeTwoBefore;
  private int known;

  /** The step being looked at. */
  private final Step step;

  /** Growth over the step before from which on a pole may be inside of this one. */
  private double leastGrowth;

  /** The component being looked at, and its derivatives at the ends of the step. */
  private int l;

  private double here;
  private double there;

  /** Whether orders of its growth other than 1 and 2 are looked for. */
  private boolean anyOrder;

  /**
   * @param dimension number of equations
   */
  PoleProbe(int dimension) {
    before = new double[dimension];
    twoBefore = new double[dimension];
    step = new Step(dimension);
  }

  /** Forgets the derivatives seen: those behind a jump tell nothing of those before it. */
  void clear() {
    known = 0;
  }

  /** Takes note of the derivative at the beginning of an accepted step. */
  void accepted(double t, double[] derivative) {
    double[] freed = twoBefore;
    twoBefore = before;
    timeTwoBefore = timeBefore;
    before = freed;
    timeBefore = t;
    System.arraycopy(derivative, 0, before, 0, before.length);
    known = Math.min(known + 1, 2);
  }

  /**
   * Returns whether the derivatives of a step turn or have grown as before a pole: the others are
   * not worth a look.
   *
   * @param t where it begins
   * @param end where it ends
   * @param derivative at its beginning
   * @param derivativeAtEnd at its end
   */
  boolean suspected(double t, double end, double[] derivative, double[] derivativeAtEnd) {
    leastGrowth = known == 0 ? Double.POSITIVE_INFINITY : 1 + (t - timeBefore) / (end - t);
    for (int i = 0; i < before.length; i++) {
      if (turnsOrGrows(before[i], derivative[i], derivativeAtEnd[i])) {
        return known > 0;
      }
    }
    return false;
  }

  private boolean turnsOrGrows(double last, double here, double there) {
    return here * there < 0 || growsUpTo(last, here);
  }

  /**
   * Places the step to be looked at.
   *
   * @param t where it begins
   * @param end where it ends
   * @param y state at its beginning; kept until the next step is placed, not modified
   * @param yEnd state at its end; likewise
   */
  void place(double t, double end, double[] y, double[] yEnd) {
    step.t = t;
    step.end = end;
    step.y = y;
    step.yEnd = yEnd;
  }

  /**
   * Returns the component with a pole inside the step suspected and placed, −1 if there is none.
   *
   * @param equations asked for further derivatives if it looks like a pole
   * @param norm what changes less in a step than it allows as an error is not looked at
   * @param derivative at its beginning
   * @param foreseen derivative at its end, extrapolated from what came before: a change of sign
   *     that it shows is no pole
   * @param derivativeAtEnd at its end
   */
  int component(
      RightHandSide equations,
      ErrorNorm norm,
      double[] derivative,
      double[] foreseen,
      double[] derivativeAtEnd) {
    for (int i = 0; i < before.length; i++) {
      if (turnsOrGrows(before[i], derivative[i], derivativeAtEnd[i])) {
        l = i;
        here = derivative[i];
        there = derivativeAtEnd[i];
        if (hasPole(equations, norm, foreseen[i])) {
          return i;
        }
      }
    }
    return -1;
  }

  /** Returns whether the component being looked at, which turns or grows, has a pole. */
  private boolean hasPole(RightHandSide equations, ErrorNorm norm, double foreseen) {
    if (!(here * before[l] > 0 && Math.abs(here) > Math.abs(before[l]))) {
      return false; // not growing
    }
    double size = Math.max(Math.abs(step.y[l]), Math.abs(step.yEnd[l]));
    double move = Math.abs(step.length() * here);
    anyOrder = known == 2 && move > VERY_MUCH * size && norm.of(step.yEnd) < MOST_TOLERANCES;
    return here * there < 0
        ? foreseen * here > 0
            && Math.abs(step.length() * there) * norm.weight(l) > 1
            && changesSignAtPole()
            && narrowed(equations)
        : here * there > 0 && move > MUCH * size && peaks(equations);
  }

  /**
   * Returns whether the derivatives known, which grow and then change sign, look like A/(t − c), or
   * like another odd growth, with c inside the step.
   */
  private boolean changesSignAtPole() {
    double last = before[l];
    double ahead = (step.t - timeBefore) * last / (here - last); // from the beginning to the pole
    double behind = -ahead * here / there; // from the pole to the end, by the values
    double earlier = here * ahead / (step.t - timeTwoBefore + ahead);
    if (alike((ahead + behind) / step.length()) && (known == 1 || alike(twoBefore[l] / earlier))) {
      return true;
    }
    boolean grows = anyOrder && growsUpTo(last, here);
    for (int i = 1; grows && i < ORDERS.length; i++) {
      double place = placeOfGrowth(ORDERS[i]);
      double distances = (1 - place) / place;
      if (place > 0
          && (alike(-there / here * power(ORDERS[i], distances))
              || alike(-there / here * distances * step.y[l] / step.yEnd[l]))) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns whether a derivative has grown so fast that its pole, if it has one, is in the step:
   * that of A/|t − c| is the nearest that the growth allows.
   */
  private boolean growsUpTo(double last, double here) {
    return Math.abs(here) > leastGrowth * Math.abs(last);
  }

  /**
   * Returns the share of the step at which the derivatives before it foretell that growth of an
   * order p, A/|t − c|^p, comes to its pole; 0 if they do not, or not inside the step.
   */
  private double placeOfGrowth(double order) {
    double ahead = (step.t - timeBefore) / (power(1 / order, here / before[l]) - 1);
    double earlier = here / power(order, (step.t - timeTwoBefore + ahead) / ahead);
    boolean foretold = known == 1 || alike(twoBefore[l] / earlier, closeness(order));
    return foretold && (step.length() - ahead) / step.length() > 0 ? ahead / step.length() : 0;
  }

  /** Returns whether there is a pole at a place that the derivatives known foretell. */
  private boolean peaks(RightHandSide equations) {
    for (int i = 0; i < (anyOrder ? ORDERS.length : USUAL); i++) {
      double place = placeOfPeak(ORDERS[i]);
      if (place > 0 && peaksNear(equations, place)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns the share of the step at which the derivatives known, which grow and keep their sign,
   * foretell a pole of constant sign; 0 if they do not. The value behind it is the one foretold if
   * f depends on t alone, or if it is y times A/|t − c|.
   *
   * @param order p for A/|t − c|^p
   */
  private double placeOfPeak(double order) {
    double place = placeOfGrowth(order);
    double distances = (1 - place) / place;
    return place > 0
            && (alike(there / here * power(order, distances), closeness(order))
                || (anyOrder
                    && order != 1
                    && alike(there / here * distances * step.y[l] / step.yEnd[l], CLOSELY_ALIKE)))
        ? place
        : 0;
  }

  private static double power(double exponent, double ratio) {
    if (exponent == 1) {
      return ratio;
    }
    if (exponent == 2) {
      return ratio * ratio;
    }
    // Unlike StrictMath.pow without arrays of its own.
    return exponent == 0.5 ? Math.sqrt(ratio) : StrictMath.exp(exponent * StrictMath.log(ratio));
  }

  private static double closeness(double order) {
    return order == 1 || order == 2 ? CLOSELY_ALIKE : VERY_CLOSELY_ALIKE;
  }

  /** Narrows the largest value down from a place; returns whether a pole is there. */
  private boolean peaksNear(RightHandSide equations, double place) {
    double from = 0;
    double to = 1;
    double top = place;
    if (!step.evaluate(equations, top)) {
      return false; // the run is to stop
    }
    double peak = Math.abs(step.slope[l]);
    if (peak <= Math.max(Math.abs(here), Math.abs(there))) {
      return false;
    }
    double least = KEPT * Math.min(Math.abs(here), Math.abs(there));
    double resolution = step.resolution();
    while (Double.isFinite(peak) && to - from > resolution) {
      boolean nearer = top - from > to - top;
      double share = 0.5 * (top + (nearer ? from : to));
      if (!step.evaluate(equations, share)) {
        return false;
      }
      double value = Math.abs(step.slope[l]);
      boolean higher = !(value <= peak);
      double edge = higher ? top : share;
      from = nearer == higher ? from : edge;
      to = nearer == higher ? edge : to;
      top = higher ? share : top;
      peak = higher ? value : peak;
      if (peak * (to - from) < least) {
        return false;
      }
    }
    return true;
  }

  private static boolean alike(double ratio) {
    return alike(ratio, ALIKE);
  }

  private static boolean alike(double ratio, double most) {
    return ratio < most && ratio > 1 / most;
  }

  /** Narrows the change of sign down; returns whether a pole is there. */
  private boolean narrowed(RightHandSide equations) {
    double from = 0;
    double to = 1;
    double first = here;
    double last = there;
    double least = KEPT * Math.min(Math.abs(here), Math.abs(there));
    double resolution = step.resolution();
    for (int i = 1; i <= ENOUGH; i++) {
      double middle = 0.5 * (from + to);
      if (!step.evaluate(equations, middle)) {
        return false; // the run is to stop
      }
      double value = step.slope[l];
      if (!Double.isFinite(value)) {
        return true;
      }
      if (first * value < 0) {
        to = middle;
        last = value;
      } else {
        from = middle;
        first = value;
      }
      if (Math.max(Math.abs(first), Math.abs(last)) * (to - from) < least) {
        return false;
      }
      if (to - from <= resolution) {
        return true; // no times are left between, and it has not fallen on the way
      }
    }
    return true;
  }

  /** Carries the derivatives seen over. */
  void transfer(SavedState state) {
    known = state.integer(known);
    state.numbers(before);
    state.numbers(twoBefore);
    timeTwoBefore = state.number(timeTwoBefore);
    timeBefore = state.number(timeBefore);
  }

  /** A step, and the derivatives on the straight line between its ends. */
  private static final class Step {
    private double t;
    private double end;
    private double[] y = {};
    private double[] yEnd = {};
    private final double[] between;
    private final double[] slope;

    Step(int dimension) {
      between = new double[dimension];
      slope = new double[dimension];
    }

    /** Returns its size, signed. */
    double length() {
      return end - t;
    }

    /** Returns the share of it within which times cannot be told apart. */
    double resolution() {
      return 4 * Math.max(Math.ulp(t), Math.ulp(end)) / Math.abs(end - t);
    }

    /** Evaluates the derivatives a share of the step ahead, unless the run is to stop. */
    boolean evaluate(RightHandSide equations, double share) {
      for (int k = 0; k < between.length; k++) {
        between[k] = y[k] + share * (yEnd[k] - y[k]);
      }
      return equations.evaluate(t + share * (end - t), between, slope);
    }
  }
}
