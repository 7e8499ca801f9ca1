package org.mechservice.solver.ode.backward;

import java.util.Arrays;

/**
 * The polynomial of degree k through the last k + 1 points of a stiff method, and its derivative.
 *
 * <p>At t = t_n + s h, −1 ≤ s ≤ 0:
 *
 * <pre>
 * y = y_n + Σ_{m=1..k} c_m ∇^m y_n,     y' = Σ_{m=1..k} c'_m ∇^m y_n / h
 * c_m = Π_{l=1..m} (s + l − 1) / l,      c'_m = dc_m / ds
 * </pre>
 */
public final class BackwardInterpolant {
  private BackwardInterpolant() {}

  /**
   * Evaluates the polynomial.
   *
   * @param s distance from t_n over h
   * @param h step size the accepted differences are written for
   * @param k order of the step
   * @param differences not modified
   * @param y overwritten
   * @param yDot overwritten
   */
  public static void evaluate(
      double s, double h, int k, BackwardDifferences differences, double[] y, double[] yDot) {
    double[] state = differences.state();
    int n = state.length;
    System.arraycopy(state, 0, y, 0, n);
    Arrays.fill(yDot, 0, n, 0);
    double c = 1;
    double slope = 0;
    for (int m = 1; m <= k; m++) {
      slope = (slope * (s + m - 1) + c) / m;
      c *= (s + m - 1) / m;
      addTerm(differences.accepted(m), c, slope / h, y, yDot);
    }
  }

  /** Returns how many numbers {@link #keep} writes: t_n, h, k, y_n, ∇^1 … ∇^k. */
  public static int keptLength(int k, int dimension) {
    return 3 + (k + 1) * dimension;
  }

  /** Keeps the polynomial of a step of size h and order k that ended at t. */
  public static void keep(
      double t, double h, int k, BackwardDifferences differences, double[] kept, int from) {
    int n = differences.state().length;
    kept[from] = t;
    kept[from + 1] = h;
    kept[from + 2] = k;
    int place = from + 3;
    System.arraycopy(differences.state(), 0, kept, place, n);
    for (int m = 1; m <= k; m++) {
      place += n;
      System.arraycopy(differences.accepted(m), 0, kept, place, n);
    }
  }

  /** Evaluates a polynomial that was kept. */
  public static void evaluateKept(double[] kept, int from, double t, double[] y, double[] yDot) {
    double h = kept[from + 1];
    double s = (t - kept[from]) / h;
    int k = (int) kept[from + 2];
    int n = y.length;
    int place = from + 3;
    System.arraycopy(kept, place, y, 0, n);
    Arrays.fill(yDot, 0);
    double c = 1;
    double slope = 0;
    for (int m = 1; m <= k; m++) {
      place += n;
      slope = (slope * (s + m - 1) + c) / m;
      c *= (s + m - 1) / m;
      addTerm(c, kept, place, y);
      addTerm(slope / h, kept, place, yDot);
    }
  }

  private static void addTerm(double factor, double[] kept, int from, double[] sum) {
    for (int l = 0; l < sum.length; l++) {
      sum[l] += factor * kept[from + l];
    }
  }

  private static void addTerm(
      double[] difference, double c, double slope, double[] y, double[] yDot) {
    for (int l = 0; l < difference.length; l++) {
      y[l] += c * difference[l];
      yDot[l] += slope * difference[l];
    }
  }
}
