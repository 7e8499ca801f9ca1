package org.mechservice.solver.ode.step;

/**
 * Norm of DE: the root of the sum of squares, the error allowed is rtol |y_i| + atol_i. Shampine
 * and Gordon 1975.
 */
public final class EuclideanNorm extends WeightedNorm {
  /** Outside of it, squares may have been lost below or above the range of numbers. */
  private static final double SMALLEST_SUM = 1e-280;

  private static final double LARGEST_SUM = 1e280;

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
    return isSafe(sum) ? Math.sqrt(sum) : 0.5 * withoutSquares(x, x);
  }

  @Override
  public double ofSum(double[] x1, double[] x2) {
    double sum = 0;
    for (int l = 0; l < weight.length; l++) {
      double part = (x1[l] + x2[l]) * weight[l];
      sum += part * part;
    }
    return isSafe(sum) ? Math.sqrt(sum) : withoutSquares(x1, x2);
  }

  private static boolean isSafe(double sum) {
    return sum > SMALLEST_SUM && sum < LARGEST_SUM;
  }

  /** The same of x1 + x2, slower. */
  private double withoutSquares(double[] x1, double[] x2) {
    double norm = 0;
    for (int l = 0; l < weight.length; l++) {
      norm = StrictMath.hypot(norm, (x1[l] + x2[l]) * weight[l]);
    }
    return norm;
  }
}
