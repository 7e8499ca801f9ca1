package org.mechservice.report.measure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * A method at a tolerance: the summary of all its runs.
 *
 * @param first the run that errors and counts are taken from; they are the same in all
 * @param seconds median of the timed runs, s; the time of the first run if none was timed
 * @param lowSeconds lower quartile, s
 * @param highSeconds upper quartile, s
 * @param repeats number of timed runs
 * @param drift median of the later half of the timed runs over that of the earlier half: 1 where
 *     the method was warm; NaN for fewer than four
 */
public record Point(
    MeasuredRun first,
    double seconds,
    double lowSeconds,
    double highSeconds,
    int repeats,
    double drift) {
  private static final int HALVES = 4;

  /** Returns the points of a journal, in the order they were first run. */
  public static List<Point> of(List<MeasuredRun> runs) {
    List<Point> points = new ArrayList<>();
    for (MeasuredRun run : runs) {
      if (run.round() == 0) {
        points.add(of(run, timesOf(run, runs)));
      }
    }
    return points;
  }

  /** In the order of the rounds; the first run, if it reached the end and none was timed. */
  private static double[] timesOf(MeasuredRun first, List<MeasuredRun> runs) {
    double[] timed = timedOf(first, runs);
    return timed.length == 0 && first.completed() ? new double[] {first.seconds()} : timed;
  }

  private static double[] timedOf(MeasuredRun first, List<MeasuredRun> runs) {
    return runs.stream()
        .filter(run -> run.round() > 0 && run.method().equals(first.method()))
        .filter(run -> run.tolerance() == first.tolerance())
        .sorted(Comparator.comparingInt(MeasuredRun::round))
        .mapToDouble(MeasuredRun::seconds)
        .toArray();
  }

  private static Point of(MeasuredRun first, double[] seconds) {
    return new Point(
        first,
        Quantiles.median(seconds),
        Quantiles.of(seconds, 0.25),
        Quantiles.of(seconds, 0.75),
        seconds.length,
        drift(seconds));
  }

  private static double drift(double[] seconds) {
    int half = seconds.length / 2;
    return seconds.length < HALVES
        ? Double.NaN
        : Quantiles.median(Arrays.copyOfRange(seconds, seconds.length - half, seconds.length))
            / Quantiles.median(Arrays.copyOfRange(seconds, 0, half));
  }

  /** Returns the requested tolerance. */
  public double tolerance() {
    return first.tolerance();
  }

  /** Returns the largest error over time. */
  public double error() {
    return first.errors().largest();
  }

  /** Returns whether it was run more than once, so that its quartiles tell something. */
  public boolean isRepeated() {
    return repeats > 1;
  }

  /**
   * Returns by how much of their median half of the times differ: the quartiles' distance; NaN of
   * one run or two.
   */
  public double spread() {
    return repeats > 2 ? (highSeconds - lowSeconds) / seconds : Double.NaN;
  }

  /**
   * Returns whether the times are indistinguishable from another point's: the quartiles overlap. Of
   * single runs it is not known.
   */
  public boolean overlaps(Point other) {
    boolean known = isRepeated() && other.isRepeated();
    return known && lowSeconds <= other.highSeconds && other.lowSeconds <= highSeconds;
  }

  /** Returns whether the end was reached. */
  public boolean completed() {
    return first.completed();
  }
}
