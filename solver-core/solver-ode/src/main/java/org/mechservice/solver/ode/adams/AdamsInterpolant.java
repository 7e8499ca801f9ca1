package org.mechservice.solver.ode.adams;

import java.util.Arrays;

/**
 * The polynomial of degree k + 1 that belongs to the last accepted step, and its derivative.
 *
 * <p>At t = t_n + s, s between −h and 0:
 *
 * <pre>
 * y  = y_n + s Σ_{i=1..k+1} g_i φ_i        y' = Σ_{i=1..k+1} ρ_i φ_i
 * γ_j = (s + ψ_{j−1}) / ψ_j,  η_j = s / ψ_j                 with ψ_0 = 0
 * g_{1,q} = 1/q,  g_{j+1,q} = γ_j g_{j,q} − η_j g_{j,q+1},  g_j = g_{j,1}
 * ρ_1 = 1,        ρ_{j+1} = γ_j ρ_j
 * </pre>
 *
 * Shampine and Gordon 1975, ch. 5 and 10. It has its own tables and leaves the history as it is.
 */
final class AdamsInterpolant {
  private static final int LENGTH = AdamsCoefficients.HIGHEST_ORDER + 2;

  /** Steps kept are evaluated by any thread; each has its own tables. */
  private static final ThreadLocal<AdamsInterpolant> TABLES =
      ThreadLocal.withInitial(AdamsInterpolant::new);

  private final double[] g = new double[LENGTH];
  private final double[] rho = new double[LENGTH];
  private final double[] w = new double[LENGTH];

  /** ψ_1 … ψ_k of a step that was kept. */
  private final double[] keptPsi = new double[LENGTH];

  /**
   * Evaluates the polynomial.
   *
   * @param s distance from the end of the step, of the sign opposite to h, or 0
   * @param k order of the step; 0 if none was taken, where only s = 0 makes sense
   * @param psi ψ_1 … ψ_k of the step; not modified
   * @param history not modified
   * @param y overwritten
   * @param yDot overwritten
   */
  void evaluate(double s, int k, double[] psi, AdamsHistory history, double[] y, double[] yDot) {
    formTables(s, k, psi);
    double[] state = history.state();
    int n = state.length;
    Arrays.fill(y, 0, n, 0);
    Arrays.fill(yDot, 0, n, 0);
    for (int i = k + 1; i >= 1; i--) {
      addTerm(history.difference(i), g[i], rho[i], y, yDot);
    }
    for (int l = 0; l < n; l++) {
      y[l] = state[l] + s * y[l];
    }
  }

  /** Returns how many numbers {@link #keep} writes: t_n, k, ψ_1 … ψ_k, y_n, φ_{k+1} … φ_1. */
  static int keptLength(int k, int dimension) {
    return 2 + k + (k + 2) * dimension;
  }

  /** Keeps the polynomial of a step of order k that ended at t. */
  static void keep(double t, int k, double[] psi, AdamsHistory history, double[] kept, int from) {
    int n = history.state().length;
    kept[from] = t;
    kept[from + 1] = k;
    System.arraycopy(psi, 1, kept, from + 2, k);
    int place = from + 2 + k;
    System.arraycopy(history.state(), 0, kept, place, n);
    for (int i = k + 1; i >= 1; i--) {
      place += n;
      System.arraycopy(history.difference(i), 0, kept, place, n);
    }
  }

  /** Evaluates a polynomial that was kept. */
  static void evaluateKept(double[] kept, int from, double t, double[] y, double[] yDot) {
    TABLES.get().evaluateFrom(kept, from, t, y, yDot);
  }

  private void evaluateFrom(double[] kept, int from, double t, double[] y, double[] yDot) {
    int n = y.length;
    int k = (int) kept[from + 1];
    double s = t - kept[from];
    System.arraycopy(kept, from + 2, keptPsi, 1, k);
    formTables(s, k, keptPsi);
    Arrays.fill(y, 0);
    Arrays.fill(yDot, 0);
    int state = from + 2 + k;
    for (int i = k + 1; i >= 1; i--) {
      int difference = state + (k + 2 - i) * n;
      addTerm(g[i], kept, difference, y);
      addTerm(rho[i], kept, difference, yDot);
    }
    for (int l = 0; l < n; l++) {
      y[l] = kept[state + l] + s * y[l];
    }
  }

  private static void addTerm(double factor, double[] kept, int from, double[] sum) {
    for (int l = 0; l < sum.length; l++) {
      sum[l] += factor * kept[from + l];
    }
  }

  private static void addTerm(
      double[] difference, double g, double rho, double[] y, double[] yDot) {
    for (int l = 0; l < difference.length; l++) {
      y[l] += g * difference[l];
      yDot[l] += rho * difference[l];
    }
  }

  private void formTables(double s, int k, double[] psi) {
    for (int q = 1; q <= k + 1; q++) {
      w[q] = 1.0 / q;
    }
    g[1] = 1;
    rho[1] = 1;
    double before = 0;
    for (int j = 1; j <= k; j++) {
      double gamma = (s + before) / psi[j];
      double eta = s / psi[j];
      for (int q = 1; q <= k + 1 - j; q++) {
        w[q] = gamma * w[q] - eta * w[q + 1];
      }
      g[j + 1] = w[1];
      rho[j + 1] = gamma * rho[j];
      before = psi[j];
    }
  }
}
