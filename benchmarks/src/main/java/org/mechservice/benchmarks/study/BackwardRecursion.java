package org.mechservice.benchmarks.study;

import java.util.Arrays;

/**
 * The numerical differentiation formula of one order on y' = i y at a constant step h = |hλ|, in
 * complex numbers: with z = i h, the differences ∇^m y and the prediction P = Σ ∇^m y, m = 0 … k,
 *
 * <p>((1 − κ) γ_k − z) d = z P − Σ γ_m ∇^m y, m = 1 … k, and y at the next step is P + d
 *
 * <p>with γ_m = 1 + 1/2 + … + 1/m and the κ of Shampine and Reichelt 1997, table 1. It is linear,
 * so after many steps the growth is that of its largest root.
 */
final class BackwardRecursion {
  static final int HIGHEST_ORDER = 5;
  private static final double[] KAPPA = {0, -0.1850, -1.0 / 9, -0.0823, -0.0415, 0};

  /** Steps until the parasitic roots have died away, or taken over. */
  private static final int SETTLING = 4000;

  private static final int MEASURED = 4000;

  private final int order;
  private final double[] gamma = new double[HIGHEST_ORDER + 1];

  /** Differences of order 0 … k, real and imaginary parts. */
  private final double[] re;

  private final double[] im;

  BackwardRecursion(int order) {
    this.order = order;
    re = new double[order + 1];
    im = new double[order + 1];
    for (int m = 1; m <= order; m++) {
      gamma[m] = gamma[m - 1] + 1.0 / m;
    }
  }

  /** Returns the factor by which the amplitude grows in a period of the oscillation. */
  double growthPerPeriod(double size) {
    start(size);
    for (int i = 0; i < SETTLING; i++) {
      step(size);
      scale();
    }
    double logarithm = 0;
    for (int i = 0; i < MEASURED; i++) {
      step(size);
      logarithm += Math.log(scale());
    }
    return Math.exp(logarithm / MEASURED * 2 * Math.PI / size);
  }

  /** Differences of the exact solution, with a little of everything else. */
  private void start(double size) {
    Arrays.fill(re, 1e-3);
    Arrays.fill(im, 0);
    re[0] = 1;
    im[0] = 0;
    // ∇ = 1 − exp(−i h)
    double factorRe = 1 - Math.cos(size);
    double factorIm = Math.sin(size);
    double a = 1;
    double b = 0;
    for (int m = 1; m <= order; m++) {
      double next = a * factorRe - b * factorIm;
      b = a * factorIm + b * factorRe;
      a = next;
      re[m] += a;
      im[m] += b;
    }
  }

  private void step(double size) {
    double predictedRe = 0;
    double predictedIm = 0;
    double sumRe = 0;
    double sumIm = 0;
    for (int m = 0; m <= order; m++) {
      predictedRe += re[m];
      predictedIm += im[m];
      sumRe += gamma[m] * re[m];
      sumIm += gamma[m] * im[m];
    }
    double rightRe = -size * predictedIm - sumRe;
    double rightIm = size * predictedRe - sumIm;
    double leading = (1 - KAPPA[order]) * gamma[order];
    double divisor = leading * leading + size * size;
    double dRe = (rightRe * leading - rightIm * size) / divisor;
    double dIm = (rightIm * leading + rightRe * size) / divisor;
    // ∇^{k+1} y is d; the lower ones follow, ∇^m new = ∇^m old + ∇^{m+1} new.
    double aboveRe = dRe;
    double aboveIm = dIm;
    for (int m = order; m >= 0; m--) {
      aboveRe += re[m];
      aboveIm += im[m];
      re[m] = aboveRe;
      im[m] = aboveIm;
    }
  }

  /** Divides all differences by the amplitude of the last step, and returns it. */
  private double scale() {
    double size = 0;
    for (int m = 0; m <= order; m++) {
      size = Math.max(size, Math.hypot(re[m], im[m]));
    }
    for (int m = 0; m <= order; m++) {
      re[m] /= size;
      im[m] /= size;
    }
    return size;
  }
}
