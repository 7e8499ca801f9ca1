package org.mechservice.report.reference;

import java.util.Arrays;

/**
 * Signs of functions along a solution, so that each zero crossing is found once.
 *
 * <p>Where a phase begins, values that rounding or the place of the last zero leave open are told
 * by the way the functions go; such a function must leave zero by more than that before its next
 * passage.
 */
final class ZeroCrossings {
  /** Rounding error of a function, in units of its largest value. */
  private static final double ROUNDING = 16 * Math.ulp(1.0);

  /** Uncertainty of a value at a zero, in units of the difference from one side to the other. */
  private static final double BLUR = 4;

  /** Part of a stretch by which to look ahead: half of the digits. */
  private static final double AHEAD = Math.sqrt(Math.ulp(1.0));

  private final Problem problem;
  private final Phases phases;
  private final double[] largest;
  private final double[] blur;
  private final int[] side;
  private final boolean[] settled;

  /** Values where the solution is now. */
  private double[] here;

  ZeroCrossings(Problem problem, Phases phases) {
    this.problem = problem;
    this.phases = phases;
    int count = phases.count();
    largest = new double[count];
    blur = new double[count];
    side = new int[count];
    settled = new boolean[count];
    here = new double[count];
  }

  /**
   * Begins a phase.
   *
   * @param stretch rest of the interval
   * @return false if a function has no value
   */
  boolean begin(double t, double[] y, double stretch) {
    if (here.length == 0) {
      return true;
    }
    if (!phases.values(t, y, here)) {
      return false;
    }
    double[] ahead = new double[here.length];
    double[] slope = new double[y.length];
    if (!problem.derivative(t, y, slope)) {
      return false;
    }
    double[] moved = y.clone();
    for (int k = 0; k < y.length; k++) {
      moved[k] += AHEAD * stretch * slope[k];
    }
    boolean goes = phases.values(t + AHEAD * stretch, moved, ahead);
    for (int i = 0; i < here.length; i++) {
      measure(i, here[i]);
      settled[i] = Math.abs(here[i]) > unsure(i);
      double told = settled[i] ? here[i] : goes ? ahead[i] - here[i] : 0;
      side[i] = (int) Math.signum(told);
    }
    return true;
  }

  private void measure(int i, double g) {
    largest[i] = Math.max(largest[i], Math.abs(g));
  }

  private double unsure(int i) {
    return Math.max(blur[i], ROUNDING * largest[i]);
  }

  /** Returns whether a value lies behind a passage that ends the phase. */
  boolean passed(int i, double g) {
    double bound = settled[i] ? 0 : unsure(i);
    boolean beyond = side[i] != 0 && (settled[i] ? g * side[i] <= 0 : g * side[i] < -bound);
    return beyond && phases.counts(i, side[i] < 0);
  }

  /** Returns whether any value does. */
  boolean anyPassed(double[] g) {
    for (int i = 0; i < g.length; i++) {
      if (passed(i, g[i])) {
        return true;
      }
    }
    return false;
  }

  /** Returns which values do. */
  boolean[] allPassed(double[] g) {
    boolean[] all = new boolean[g.length];
    for (int i = 0; i < g.length; i++) {
      all[i] = passed(i, g[i]);
    }
    return all;
  }

  /** Returns the values where the solution is now; not to be modified. */
  double[] here() {
    return here;
  }

  /** Goes on to values of the same phase. */
  void moveTo(double[] g) {
    for (int i = 0; i < g.length; i++) {
      measure(i, g[i]);
      if (Math.abs(g[i]) > unsure(i)) {
        side[i] = (int) Math.signum(g[i]);
        settled[i] = true;
        blur[i] = 0;
      }
    }
    here = g;
  }

  /** Keeps how well a zero is known, by the values on both of its sides. */
  void located(double[] before, double[] behind) {
    Arrays.setAll(blur, i -> BLUR * Math.abs(behind[i] - before[i]));
  }
}
