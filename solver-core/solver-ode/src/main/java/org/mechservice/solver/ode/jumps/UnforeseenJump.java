package org.mechservice.solver.ode.jumps;

import org.mechservice.solver.ode.step.ExtrapolatedStep;
import org.mechservice.solver.ode.step.RightHandSide;

/**
 * Looks for a jump of f inside a step that passes the error test.
 *
 * <p>Formulas of high order think little of the last value of f: where f jumps by J, the error of
 * the step is up to h J / 2, and its estimate h γ*_k J, at order 8 a fiftieth of that. What the
 * jump leaves is a discrepancy d that the differences before it do not foretell. Those of a smooth
 * solution fall from order to order, so that d is at most about as large as φ*_k; at a jump d is
 * larger than all of the last ones. A few smooth steps look like that too, where several
 * differences pass zero together. So f is then compared, at halves of halves of the step, with its
 * extrapolation: most of the difference d that a jump makes stays in one of the halves; that of a
 * smooth solution grows like a polynomial without zeros in the step, and is divided up.
 */
final class UnforeseenJump {
  /**
   * Discrepancy over the last two differences before it from which on it is worth a look, and over
   * the one before those: no step of the suite of smooth problems is looked at, at any tolerance.
   */
  private static final double SUDDEN = 30;

  private static final double LARGE = 2;

  /** The same once jumps are known in the problem. */
  private static final double SUDDEN_AGAIN = 3;

  private static final double LARGE_AGAIN = 0.3;

  /**
   * Part of the change that a jump keeps after all halvings. The polynomial θ (θ + 1) … (θ + k − 1)
   * / k! of equal steps keeps less after two, that of steps that double after three.
   */
  private static final double KEPT = 0.6;

  private static final int HALVINGS = 6;

  /** Smallest change over half the distance of looks, in allowed errors, that is noticed. */
  private static final double NOTICED = 1;

  /** The same over the discrepancy at the end of the step, which inside is less. */
  private static final double FAR_FROM_SMOOTH = 4;

  private final double[] state;
  private final double[] foreseen;
  private final double[] slope;

  /**
   * @param dimension n
   */
  UnforeseenJump(int dimension) {
    state = new double[dimension];
    foreseen = new double[dimension];
    slope = new double[dimension];
  }

  /**
   * Returns whether the discrepancy of a step is larger than the differences before it foretell.
   *
   * @param component in which it is largest
   * @param jumpsKnown whether f is known to jump
   */
  boolean suspected(ExtrapolatedStep step, int component, boolean jumpsKnown) {
    int k = step.order();
    if (k < 2) {
      return false; // the first difference is f itself
    }
    double last =
        Math.max(
            step.difference(k + 1, component),
            Math.max(difference(step, k, component), difference(step, k - 1, component)));
    double size = Math.abs(discrepancy(step, component));
    return size > (jumpsKnown ? SUDDEN_AGAIN : SUDDEN) * last
        && size > (jumpsKnown ? LARGE_AGAIN : LARGE) * difference(step, k - 2, component);
  }

  /** Returns what f at the end of a step differs by from its extrapolation. */
  private static double discrepancy(ExtrapolatedStep step, int component) {
    return step.slopeAtEnd()[component] - step.foreseenSlope()[component];
  }

  /** Returns the size of a difference; 0 for f itself. */
  private static double difference(ExtrapolatedStep step, int i, int component) {
    return i < 2 ? 0 : step.difference(i, component);
  }

  /**
   * Returns whether f jumps inside a step; false also if it is told to stop.
   *
   * @param component in which f differs most from its extrapolation
   */
  boolean found(RightHandSide equations, ExtrapolatedStep step, int component) {
    double t = step.progress().time();
    double from = 0;
    double to = 1;
    double before = 0;
    double behind = discrepancy(step, component);
    double least = KEPT * Math.abs(behind);
    for (int i = 1; i <= HALVINGS; i++) {
      double middle = 0.5 * (from + to);
      step.extrapolate(middle, state, foreseen);
      if (!equations.evaluate(t + middle * step.size(), state, slope)) {
        return false;
      }
      double value = slope[component] - foreseen[component];
      if (Math.abs(value - before) < Math.abs(value - behind)) {
        from = middle;
        before = value;
      } else {
        to = middle;
        behind = value;
      }
      if (i > 1 && !(Math.abs(behind - before) >= least)) {
        return false;
      }
    }
    return true;
  }

  /**
   * Returns the part of a step that passed up to the first look at which f is far from its
   * extrapolation, as between two jumps that cancel each other; 1 if there is none.
   *
   * @param parts into which the looks divide the step
   */
  double partToPulse(RightHandSide equations, ExtrapolatedStep step, int parts) {
    double t = step.progress().time();
    double h = step.size();
    double half = 0.5 * Math.abs(h);
    double noticed = Math.max(NOTICED * parts, FAR_FROM_SMOOTH * half * step.discrepancy());
    for (int i = 1; i < parts; i++) {
      double part = (double) i / parts;
      step.extrapolate(part, state, foreseen);
      if (!equations.evaluate(t + part * h, state, slope)) {
        return 1;
      }
      for (int l = 0; l < slope.length; l++) {
        slope[l] -= foreseen[l];
      }
      if (half * step.norm().of(slope) > noticed) {
        return part;
      }
    }
    return 1;
  }
}
