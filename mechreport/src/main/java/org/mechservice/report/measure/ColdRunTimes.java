package org.mechservice.report.measure;

import java.util.Arrays;

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
    double[] sorted = seconds.clone();
    Arrays.sort(sorted);
    int count = sorted.length;
    return new ColdRunTimes(sorted[count / 2], sorted[0], sorted[count - 1], count);
  }
}
