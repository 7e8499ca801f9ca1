package org.mechservice.solver.ode.step;

/**
 * Norm of ode113 and ode15s: the largest component counts, the error allowed is max(rtol |y_i|,
 * atol_i). Shampine and Reichelt 1997.
 *
 * <p>Magnitudes have the order of their bits, NaN above all: the largest is found among integers,
 * whose comparisons wait less for each other.
 */
public final class MaximumNorm extends WeightedNorm {
  /** Part of the tolerances that is allowed. */
  private double part = 1;

  /** Allows a part of the tolerances from the next {@link #weigh} on. */
  public void allow(double part) {
    this.part = part;
  }

  @Override
  double allowed(double relativeTolerance, double size, double absoluteTolerance) {
    double relative = relativeTolerance * size;
    return part * (relative <= absoluteTolerance ? absoluteTolerance : relative);
  }

  @Override
  public double of(double[] x) {
    long largest = 0;
    for (int l = 0; l < weight.length; l++) {
      largest = Math.max(largest, magnitude(x[l] * weight[l]));
    }
    return Double.longBitsToDouble(largest);
  }

  @Override
  public double ofSum(double[] x1, double[] x2) {
    long largest = 0;
    for (int l = 0; l < weight.length; l++) {
      largest = Math.max(largest, magnitude((x1[l] + x2[l]) * weight[l]));
    }
    return Double.longBitsToDouble(largest);
  }

  /** Returns the bits of |x| as an integer; NaN may have either sign and is the largest here. */
  private static long magnitude(double x) {
    return Double.doubleToRawLongBits(x) & Long.MAX_VALUE;
  }
}
