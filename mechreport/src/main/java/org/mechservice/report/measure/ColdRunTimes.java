package org.mechservice.report.measure;

import org.apache.commons.math3.stat.StatUtils;

/**
 * Times of first runs, each in a new Java process, the start of Java included.
 *
 * @param seconds median, s
 * @param least s
 * @param most s
 * @param count number of runs
 */
public record ColdRunTimes(double seconds, double least, double most, int count) {
  /** Returns the summary of times, at least one. */
  static ColdRunTimes of(double[] seconds) {
    return new ColdRunTimes(
        Quantiles.median(seconds), StatUtils.min(seconds), StatUtils.max(seconds), seconds.length);
  }
}
