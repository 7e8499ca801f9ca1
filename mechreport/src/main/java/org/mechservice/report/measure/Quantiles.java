package org.mechservice.report.measure;

import org.apache.commons.math3.stat.descriptive.rank.Percentile;

/**
 * Quantiles of a sample, interpolated linearly between its order statistics (type 7 of Hyndman and
 * Fan 1996, as in R and NumPy).
 */
public final class Quantiles {
  private Quantiles() {}

  /**
   * Returns the median; NaN of an empty sample.
   *
   * @param sample in any order. Not modified.
   */
  public static double median(double... sample) {
    return of(sample, 0.5);
  }

  /**
   * Returns a quantile; NaN of an empty sample.
   *
   * @param sample in any order. Not modified.
   * @param part of the sample that lies below it, more than 0 and at most 1
   */
  public static double of(double[] sample, double part) {
    return new Percentile()
        .withEstimationType(Percentile.EstimationType.R_7)
        .evaluate(sample, 100 * part);
  }
}
