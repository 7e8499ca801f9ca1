package org.mechservice.solver.ode.backward;

import java.util.Optional;

/**
 * Formulas of orders 1 to 5 on equal steps for y' = f at the new point, written with the backward
 * differences ∇^m y_n and the extrapolation y* = Σ_{m=0..k} ∇^m y_n:
 *
 * <pre>
 * (1 − κ_k) γ_k (y_{n+1} − y*) + Σ_{m=1..k} γ_m ∇^m y_n = h f(t_{n+1}, y_{n+1}),  γ_k = Σ_{j≤k} 1/j
 * local error = C_k ∇^{k+1} y_{n+1},                                     C_k = κ_k γ_k + 1/(k + 1)
 * </pre>
 *
 * Shampine and Reichelt 1997, §2.
 */
public final class BackwardFormulas {
  /** Highest order. */
  public static final int HIGHEST_ORDER = 5;

  /**
   * Numerical differentiation formulas, Klopfenstein 1971: the backward differentiation formulas
   * plus a multiple of the next difference that makes the step 26, 26, 26, 12 and 0 % longer at the
   * same error. A(α)-stable with α = 90°, 90°, 80°, 66°, 51°.
   */
  public static final BackwardFormulas NDF =
      new BackwardFormulas(-0.1850, -1.0 / 9, -0.0823, -0.0415, 0);

  /** Backward differentiation formulas, Gear 1971; α = 90°, 90°, 86°, 73°, 51°. */
  public static final BackwardFormulas BDF = new BackwardFormulas(0, 0, 0, 0, 0);

  private final double[] kappa;
  private final double[] gamma = new double[HIGHEST_ORDER + 1];
  private final double[] leading = new double[HIGHEST_ORDER + 1];
  private final double[] errorConstant = new double[HIGHEST_ORDER + 1];

  /** Formed when asked for first; forming it twice is harmless. */
  private Optional<UnstableSteps> unstable = Optional.empty();

  /** Of m in row k. */
  private final double[][] share = new double[HIGHEST_ORDER + 1][HIGHEST_ORDER + 1];

  private BackwardFormulas(double... kappa) {
    this.kappa = kappa.clone();
    for (int k = 1; k <= HIGHEST_ORDER; k++) {
      gamma[k] = gamma[k - 1] + 1.0 / k;
      leading[k] = (1 - kappa[k - 1]) * gamma[k];
      errorConstant[k] = kappa[k - 1] * gamma[k] + 1.0 / (k + 1);
      for (int m = 1; m <= k; m++) {
        share[k][m] = gamma[m] / leading[k];
      }
    }
  }

  /** Returns γ_m / ((1 − κ_k) γ_k), the share of ∇^m in ψ. */
  double share(int m, int k) {
    return share[k][m];
  }

  /** Returns (1 − κ_k) γ_k, the factor of the unknown. */
  public double leading(int k) {
    return leading[k];
  }

  /** Returns where these formulas make damped oscillations grow. */
  UnstableSteps unstable() {
    Optional<UnstableSteps> known = unstable;
    if (known.isEmpty()) {
      known = Optional.of(new UnstableSteps(this));
      unstable = known;
    }
    return known.get();
  }

  /** Returns γ_k. */
  double gamma(int k) {
    return gamma[k];
  }

  /** Returns κ_k. */
  double kappa(int k) {
    return kappa[k - 1];
  }

  /** Returns C_k. */
  public double errorConstant(int k) {
    return errorConstant[k];
  }
}
