package org.mechservice.report.solution;

import java.util.Optional;

/**
 * Output times of a run that meet given times: equally spaced, as runs put out rows.
 *
 * @param start s
 * @param step distance, s
 * @param rows number of rows
 */
public record RunGrid(double start, double step, int rows) {
  private static final double ROUNDING = 1e-9;
  private static final int MOST_ROWS = 20_000;

  /** Returns equally spaced times. */
  public static RunGrid uniform(double start, double end, int intervals) {
    return new RunGrid(start, (end - start) / intervals, intervals + 1);
  }

  /**
   * Returns the coarsest grid that meets all times.
   *
   * @param times increasing, at least two
   * @return empty if the times have no common step that is not far too small
   */
  public static Optional<RunGrid> meeting(double[] times) {
    double step = times[1] - times[0];
    for (int i = 2; i < times.length; i++) {
      step = common(step, times[i] - times[0]);
    }
    double count = Math.rint((times[times.length - 1] - times[0]) / step);
    return count < MOST_ROWS
        ? Optional.of(new RunGrid(times[0], step, (int) count + 1))
        : Optional.empty();
  }

  /** Euclid's algorithm. */
  private static double common(double a, double b) {
    double larger = Math.max(a, b);
    double smaller = Math.min(a, b);
    double scale = larger;
    while (smaller > ROUNDING * scale) {
      double rest = larger - smaller * Math.rint(larger / smaller);
      larger = smaller;
      smaller = Math.abs(rest);
    }
    return larger;
  }

  /** Returns all times. */
  public double[] times() {
    double[] times = new double[rows];
    for (int i = 0; i < rows; i++) {
      times[i] = start + i * step;
    }
    return times;
  }

  /** Returns whether a time is one of the grid's. */
  public boolean meets(double time) {
    return Math.abs(time - start - row(time) * step) <= ROUNDING * step;
  }

  /** Returns the row at a time. */
  public int row(double time) {
    return (int) Math.rint((time - start) / step);
  }
}
