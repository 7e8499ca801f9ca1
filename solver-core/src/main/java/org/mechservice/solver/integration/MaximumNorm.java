package org.mechservice.solver.integration;

/**
 * Norm of ode113 and ode15s: the largest component counts, the error allowed is max(rtol |y_i|,
 * atol_i). Shampine and Reichelt 1997.
 */
final class MaximumNorm extends WeightedNorm {
  /** Part of the tolerances that is allowed. */
  private double part = 1;

  /** Allows a part of the tolerances from the next {@link #weigh} on. */
  void allow(double part) {
    this.part = part;
  }

  @Override
  double allowed(double relativeTolerance, double size, double absoluteTolerance) {
    return part * Math.max(relativeTolerance * size, absoluteTolerance);
  }

  @Override
  public double of(double[] x) {
    double norm = 0;
    for (int l = 0; l < weight.length; l++) {
      norm = Math.max(norm, Math.abs(x[l]) * weight[l]);
    }
    return norm;
  }

  @Override
  public double ofSum(double[] x1, double[] x2) {
    double norm = 0;
    for (int l = 0; l < weight.length; l++) {
      norm = Math.max(norm, Math.abs(x1[l] + x2[l]) * weight[l]);
    }
    return norm;
  }
}
