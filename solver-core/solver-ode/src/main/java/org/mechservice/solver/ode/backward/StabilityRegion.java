package org.mechservice.solver.ode.backward;

/**
 * Where a formula on equal steps amplifies a motion y' = λ y. With w = 1/ζ, ζ the factor of a step,
 * and z = h λ:
 *
 * <pre>
 * P(w) = Σ_{m=1..k} (1 − w)^m / m − κ_k γ_k (1 − w)^{k+1} − z = 0
 * </pre>
 *
 * <p>A motion grows if a root lies in |w| &lt; 1. The criterion of Schur and Cohn decides that
 * without the roots: a polynomial p of degree n has none in the unit disc if |p_0| &gt; |p_n| and
 * conj(p_0) p(w) − p_n wⁿ conj(p(1/conj(w))), of degree n − 1, has none. Henrici, <i>Applied and
 * Computational Complex Analysis</i> 1, 1974, §6.8.
 */
final class StabilityRegion {
  /**
   * Growth per step that counts: at orders 3 to 5 oscillations that are well resolved grow too, but
   * by less.
   */
  private static final double GROWTH = 1.0005;

  /** Of order k in row k: P + z, with w scaled by {@link #GROWTH}. */
  private final double[][] coefficients;

  private final double[] real;
  private final double[] imaginary;

  StabilityRegion(BackwardFormulas formulas) {
    int highest = BackwardFormulas.HIGHEST_ORDER;
    coefficients = new double[highest + 1][highest + 2];
    for (int k = 1; k <= highest; k++) {
      for (int m = 1; m <= k; m++) {
        addPower(coefficients[k], m, 1.0 / m);
      }
      addPower(coefficients[k], k + 1, formulas.furtherShare(k));
    }
    real = new double[highest + 2];
    imaginary = new double[highest + 2];
  }

  /** Adds a multiple of (1 − w / GROWTH)^m. */
  private static void addPower(double[] polynomial, int m, double factor) {
    double term = factor;
    for (int j = 0; j <= m; j++) {
      polynomial[j] += term;
      term *= -(double) (m - j) / ((j + 1) * GROWTH);
    }
  }

  /**
   * Returns whether order k amplifies a motion.
   *
   * @param re real part of h λ
   * @param im its imaginary part
   */
  boolean amplifies(int k, double re, double im) {
    double[] polynomial = coefficients[k];
    int degree = polynomial[k + 1] == 0 ? k : k + 1;
    for (int j = 0; j <= degree; j++) {
      real[j] = polynomial[j];
      imaginary[j] = 0;
    }
    real[0] -= re;
    imaginary[0] -= im;
    while (degree > 0) {
      if (size(0) <= size(degree)) {
        return true;
      }
      reduce(degree);
      degree--;
    }
    return false;
  }

  private double size(int j) {
    return real[j] * real[j] + imaginary[j] * imaginary[j];
  }

  /** Forms the polynomial of the next lower degree; both ends of it at once. */
  private void reduce(int degree) {
    double re0 = real[0];
    double im0 = imaginary[0];
    double reN = real[degree];
    double imN = imaginary[degree];
    double largest = 0;
    for (int j = 0; 2 * j <= degree; j++) {
      int i = degree - j;
      double reJ = real[j];
      double imJ = imaginary[j];
      double reI = real[i];
      double imI = imaginary[i];
      real[j] = re0 * reJ + im0 * imJ - reN * reI - imN * imI;
      imaginary[j] = re0 * imJ - im0 * reJ - imN * reI + reN * imI;
      real[i] = re0 * reI + im0 * imI - reN * reJ - imN * imJ;
      imaginary[i] = re0 * imI - im0 * reI - imN * reJ + reN * imJ;
      largest = Math.max(largest, Math.max(Math.abs(real[j]), Math.abs(imaginary[j])));
      if (j > 0) {
        largest = Math.max(largest, Math.max(Math.abs(real[i]), Math.abs(imaginary[i])));
      }
    }
    for (int j = 0; j < degree; j++) {
      real[j] /= largest;
      imaginary[j] /= largest;
    }
  }
}
