package org.mechservice.solver.integration;

/**
 * Norm of DE: the root of the sum of squares, the error allowed is rtol |y_i| + atol_i. Shampine
 * and Gordon 1975.
 */
final class EuclideanNorm extends WeightedNorm {
  @Override
  double allowed(double relativeTolerance, double size, double absoluteTolerance) {
    return relativeTolerance * size + absoluteTolerance;
  }

  @Override
  public double of(double[] x) {
    double sum = 0;
    for (int l = 0; l < weight.length; l++) {
      double part = x[l] * weight[l];
      sum += part * part;
    }
    return Math.sqrt(sum);
  }

  @Override
  public double ofSum(double[] x1, double[] x2) {
    double sum = 0;
    for (int l = 0; l < weight.length; l++) {
      double part = (x1[l] + x2[l]) * weight[l];
      sum += part * part;
    }
    return Math.sqrt(sum);
  }
}
