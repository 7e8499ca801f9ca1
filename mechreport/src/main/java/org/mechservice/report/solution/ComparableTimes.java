package org.mechservice.report.solution;

import java.util.List;
import java.util.stream.IntStream;

/**
 * Times at which states that jump can be compared: a method that is late by a rounding error is
 * charged no jump there, and one that is late by more than the margin is.
 */
final class ComparableTimes {
  private static final double MARGIN = 0.25;

  private ComparableTimes() {}

  /**
   * Returns which times lie clear of jumps, by a quarter of the smallest distance of times or of
   * that of the jumps before and behind, whichever is less; the first always does.
   *
   * @param times increasing
   * @param courses jumps as one code found them, and as another did; each increasing
   */
  static int[] of(double[] times, List<List<Double>> courses) {
    double step =
        IntStream.range(1, times.length)
            .mapToDouble(i -> times[i] - times[i - 1])
            .min()
            .orElse(Double.POSITIVE_INFINITY);
    return IntStream.range(0, times.length)
        .filter(i -> i == 0 || courses.stream().allMatch(jumps -> isClear(times[i], step, jumps)))
        .toArray();
  }

  private static boolean isClear(double t, double step, List<Double> jumps) {
    double before = Double.NEGATIVE_INFINITY;
    double behind = Double.POSITIVE_INFINITY;
    for (double jump : jumps) {
      if (jump <= t) {
        before = jump;
      } else {
        behind = Math.min(behind, jump);
      }
    }
    double margin = MARGIN * Math.min(step, behind - before);
    return t - before >= margin && behind - t >= margin;
  }
}
