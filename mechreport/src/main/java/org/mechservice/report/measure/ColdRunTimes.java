package org.mechservice.report.measure;

import org.apache.commons.math3.stat.StatUtils;

/**
 * Times of first runs, each in a Java machine of its own, its start included.
 *
 * @param seconds median, s
 * @param least s
 * @param most s
 * @param count number of runs
 */
public record ColdRunTimes(double seconds, double least, double most, int count) {
  /** Returns what times, at least one, say together. */
  static ColdRunTimes of(double[] seconds) {
    return new ColdRunTimes(
        Quantiles.median(seconds), StatUtils.min(seconds), StatUtils.max(seconds), seconds.length);
  }
}
