package org.mechservice.library.proof;

import java.util.Arrays;

/**
 * Motions of {@link PlainSystem}s by extrapolation of the modified midpoint rule (Gragg, Bulirsch
 * and Stoer; Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I, 1993, section
 * II.9) at 1e-13, which shares nothing with the integrators, the events and the laws of the
 * product. A step is on one branch. Far from every margin it may be as long as nothing can happen
 * in it; near one, steps are short, and one in which a margin has changed its sign is taken again
 * and ends there.
 */
final class PlainMotion {
  private static final double TOLERANCE = 1e-13;

  /** Numbers of midpoint steps: an extrapolation of order 14. */
  private static final int[] PARTS = {2, 4, 6, 8, 10, 12, 14};

  /**
   * Part of a fine step below which none is divided further: an error that is still there then is
   * one of rounding, by the stiffness of a contact.
   */
  private static final double SHORTEST = 4;

  private final PlainSystem system;
  private final int n;
  private final boolean[] above;
  private final double[][][] tableau;
  private final double[] next;
  private final double[] rates;

  private PlainMotion(PlainSystem system) {
    this.system = system;
    n = system.states();
    above = new boolean[system.margins()];
    tableau = new double[PARTS.length][PARTS.length][n];
    next = new double[n];
    rates = new double[n];
  }

  /** Returns the state at a time. */
  static double[] end(PlainSystem system, double[] start, double end) {
    return new PlainMotion(system).run(start, end);
  }

  private double[] run(double[] start, double end) {
    double[] y = start.clone();
    double t = 0;
    for (int i = 0; i < above.length; i++) {
      above[i] = system.margin(i, 0, y) > 0;
    }
    double step = end;
    double least = 1e-15 * end;
    double shortest = Math.max(1e-12 * end, system.fine() / SHORTEST);
    while (end - t > least) {
      double longest = Math.max(system.clear(t, y), system.fine());
      double h = Math.min(Math.min(step, longest), end - t);
      double error = step(t, y, h);
      if (error > 1 && h > shortest) {
        step = h / 2;
        continue;
      }
      step = error < 0.05 ? 2 * h : h;
      if (crossed(t + h, next) >= 0) {
        h = crossing(t, y, h);
        step = system.fine();
      }
      t += h;
      System.arraycopy(next, 0, y, 0, n);
    }
    return y;
  }

  private int crossed(double t, double[] y) {
    for (int i = 0; i < above.length; i++) {
      if (system.margin(i, t, y) > 0 != above[i]) {
        return i;
      }
    }
    return -1;
  }

  /**
   * Takes the step after which the first margin has just changed its sign, and changes the branch.
   */
  private double crossing(double t, double[] y, double h) {
    double low = 0;
    double high = h;
    for (int k = 0; k < 60 && high - low > 1e-16 * (t + h); k++) {
      double middle = 0.5 * (low + high);
      step(t, y, middle);
      if (crossed(t + middle, next) >= 0) {
        high = middle;
      } else {
        low = middle;
      }
    }
    step(t, y, high);
    int first = crossed(t + high, next);
    above[first] = !above[first];
    return high;
  }

  /** Takes a step into {@link #next}; returns its error, where 1 is allowed. */
  private double step(double t, double[] y, double h) {
    for (int j = 0; j < PARTS.length; j++) {
      midpoint(t, y, h, PARTS[j], tableau[j][0]);
      for (int k = 1; k <= j; k++) {
        double ratio = (double) PARTS[j] / PARTS[j - k];
        for (int i = 0; i < n; i++) {
          tableau[j][k][i] =
              tableau[j][k - 1][i]
                  + (tableau[j][k - 1][i] - tableau[j - 1][k - 1][i]) / (ratio * ratio - 1);
        }
      }
    }
    int last = PARTS.length - 1;
    double error = 0;
    for (int i = 0; i < n; i++) {
      next[i] = tableau[last][last][i];
      double size = Math.max(Math.abs(y[i]), Math.abs(next[i])) + 1e-3;
      error = Math.max(error, Math.abs(next[i] - tableau[last][last - 1][i]) / (TOLERANCE * size));
    }
    return Double.isNaN(error) ? Double.POSITIVE_INFINITY : error;
  }

  private void midpoint(double t, double[] y, double h, int parts, double[] result) {
    double part = h / parts;
    double[] before = y.clone();
    system.rates(t, y, above, rates);
    double[] at = new double[n];
    for (int i = 0; i < n; i++) {
      at[i] = y[i] + part * rates[i];
    }
    for (int k = 1; k < parts; k++) {
      system.rates(t + k * part, at, above, rates);
      for (int i = 0; i < n; i++) {
        double after = before[i] + 2 * part * rates[i];
        before[i] = at[i];
        at[i] = after;
      }
    }
    system.rates(t + h, at, above, rates);
    for (int i = 0; i < n; i++) {
      result[i] = 0.5 * (at[i] + before[i] + part * rates[i]);
    }
  }

  /**
   * Returns derivatives of the end by the start: element i, j of state i by start j; by central
   * differences of 1e-7 of the scale of each state.
   */
  static double[][] sensitivity(PlainSystem system, double[] start, double end, double[] scale) {
    int n = start.length;
    double[][] result = new double[n][n];
    for (int j = 0; j < n; j++) {
      double change = 1e-7 * scale[j];
      double[] up = start.clone();
      double[] down = start.clone();
      up[j] += change;
      down[j] -= change;
      double[] higher = end(system, up, end);
      double[] lower = end(system, down, end);
      for (int i = 0; i < n; i++) {
        result[i][j] = (higher[i] - lower[i]) / (2 * change);
      }
    }
    return result;
  }

  @Override
  public String toString() {
    return system + " " + Arrays.toString(above);
  }
}
