package org.mechservice.solver.ode.adams;

import java.util.Arrays;
import org.mechservice.solver.ode.SavedState;

/**
 * Coefficients of the Adams formulas on unequal steps, kept up from step to step.
 *
 * <p>With the steps h_n (the one being tried), h_{n−1}, … the formulas are built of
 *
 * <pre>
 * ψ_i = h_n + … + h_{n−i+1}                          stretch covered by i steps
 * α_i = h_n / ψ_i
 * β_i = β_{i−1} ψ_{i−1} / ψ_{i−1}(one step earlier),  β_1 = 1      turns φ_i into φ*_i
 * σ_{i+1} = i α_i σ_i,                                σ_1 = 1      scales the error estimates
 * g_i:  p = y + h Σ g_i φ*_i,                         g_1 = 1, g_2 = ½
 * </pre>
 *
 * g comes from the triangular table g_{i,q} = g_{i−1,q} − α_{i−1} g_{i−1,q+1} with g_{1,q} =
 * 1/(q(q+1)), g_i = g_{i,1}. As long as the step keeps its size, its first columns keep their
 * values: {@code n_s} counts the steps of equal size, and only entries beyond it are computed anew.
 * Shampine and Gordon 1975, ch. 5; Hairer, Nørsett and Wanner I, III.5.
 *
 * <p>All arrays count from 1, as in the literature. What is tried stays apart from what is accepted
 * until {@link #accept}, so that a step may be tried again and the last one interpolated meanwhile.
 */
final class AdamsCoefficients {
  /** Highest order of the predictor. */
  static final int HIGHEST_ORDER = 12;

  private static final int LENGTH = HIGHEST_ORDER + 3;

  /** g_{1,q}, the first row of the table. */
  private static final double[] FIRST_ROW = new double[LENGTH];

  static {
    for (int q = 1; q < LENGTH; q++) {
      FIRST_ROW[q] = 1.0 / (q * (q + 1));
    }
  }

  /** β_1 … β_k of the step being tried; 1 up to {@link #equalSteps}. */
  final double[] beta = new double[LENGTH];

  /** σ_1 … σ_{k+1} of the step being tried. */
  final double[] sigma = new double[LENGTH];

  /** g_1 … g_{k+1} of the step being tried. */
  final double[] g = new double[LENGTH];

  /** ψ_1 … ψ_k of the last accepted step. */
  final double[] psi = new double[LENGTH];

  private final double[] psiTried = new double[LENGTH];
  private final double[] alpha = new double[LENGTH];

  /** The table's diagonal that the next step of equal size starts from. */
  private final double[] v = new double[LENGTH];

  /** The table's row being reduced. */
  private final double[] w = new double[LENGTH];

  private int equalSteps;
  private double lastSize;
  private int lastOrder;

  /** Forgets all steps. */
  void clear() {
    Arrays.fill(psi, 0);
    g[1] = 1;
    g[2] = 0.5;
    sigma[1] = 1;
    beta[1] = 1;
    equalSteps = 0;
    lastSize = 0;
    lastOrder = 0;
  }

  /** Forgets the steps for those to come, but not what the last one is interpolated with. */
  void beginAgain() {
    equalSteps = 0;
    lastSize = 0;
    lastOrder = 0;
  }

  /** Returns n_s, the number of steps of equal size, the one being tried included. */
  int equalSteps() {
    return equalSteps;
  }

  /**
   * Prepares a step.
   *
   * @param h its size, signed
   * @param k order of the predictor, at most one above that of the last accepted step
   */
  void prepare(double h, int k) {
    if (h != lastSize) {
      equalSteps = 0;
    }
    if (equalSteps <= lastOrder) {
      equalSteps++;
    }
    for (int i = 1; i <= Math.min(equalSteps, k); i++) {
      psiTried[i] = h * i;
    }
    if (k >= equalSteps) {
      alpha[equalSteps] = 1.0 / equalSteps;
      beta[equalSteps] = 1;
      sigma[equalSteps + 1] = 1;
      startTable(k);
      formUnequal(h, k);
    }
  }

  /** Makes the step prepared last the last accepted one. */
  void accept(double h, int k) {
    System.arraycopy(psiTried, 1, psi, 1, k);
    lastSize = h;
    lastOrder = k;
  }

  /**
   * Forms ψ_i, α_i, β_i and σ_{i+1} beyond the steps of equal size, and each row of the table with
   * them: the divisions for β wait for each other, which leaves time for a row.
   */
  private void formUnequal(double h, int k) {
    double stretch = psiTried[equalSteps];
    double scale = beta[equalSteps];
    double weight = sigma[equalSteps + 1];
    for (int i = equalSteps + 1; i <= k; i++) {
      double before = psi[i - 1];
      scale = scale * stretch / before;
      stretch = before + h;
      double share = h / stretch;
      weight = i * share * weight;
      psiTried[i] = stretch;
      alpha[i] = share;
      beta[i] = scale;
      sigma[i + 1] = weight;
      reduceTable(k, i);
    }
  }

  /** Brings v to the diagonal that belongs to n_s steps of equal size. */
  private void startTable(int k) {
    int ns = equalSteps;
    if (ns == 1) {
      System.arraycopy(FIRST_ROW, 1, v, 1, k);
      System.arraycopy(FIRST_ROW, 1, w, 1, k);
      return;
    }
    if (k > lastOrder) {
      v[k] = FIRST_ROW[k];
      for (int j = 1; j <= ns - 2; j++) {
        v[k - j] -= alpha[j + 1] * v[k - j + 1];
      }
    }
    for (int q = 1; q <= k + 1 - ns; q++) {
      v[q] -= alpha[ns] * v[q + 1];
      w[q] = v[q];
    }
    g[ns + 1] = w[1];
  }

  /** Reduces the table by a row, whose head is g_{i+1}. */
  private void reduceTable(int k, int i) {
    double share = alpha[i];
    for (int q = 1; q <= k + 1 - i; q++) {
      w[q] -= share * w[q + 1];
    }
    g[i + 1] = w[1];
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    state.numbers(beta);
    state.numbers(sigma);
    state.numbers(g);
    state.numbers(psi);
    state.numbers(alpha);
    state.numbers(v);
    equalSteps = state.integer(equalSteps);
    lastSize = state.number(lastSize);
    lastOrder = state.integer(lastOrder);
  }
}
