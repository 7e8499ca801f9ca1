package org.mechservice.report.measure;

import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * How much a report measures.
 *
 * @param name for the page
 * @param tolerances relative tolerances, loosest first
 * @param limitSeconds after which a single run is stopped, s
 * @param timingSeconds for all timed runs together, s
 * @param referenceSeconds for one solution of the reference, s
 * @param warmSeconds per method before it is timed, s
 * @param freshStarts runs in a fresh JVM per method
 */
@SuppressWarnings("ArrayRecordComponent") // constants, not changed
public record Effort(
    String name,
    double[] tolerances,
    double limitSeconds,
    double timingSeconds,
    double referenceSeconds,
    double warmSeconds,
    int freshStarts) {
  /** Timed runs per point, as far as {@code timingSeconds} allows. */
  public static final int REPEATS = 11;

  /** Timed runs of a point that takes long. */
  public static final int FEWEST_REPEATS = 3;

  /** Under a minute. */
  public static final Effort QUICK =
      new Effort("quick", new double[] {1e-3, 1e-5, 1e-7, 1e-9}, 0.6, 14, 4, 0.15, 1);

  /** Tolerances from 1e-3 to 1e-12. */
  public static final Effort FULL = new Effort("full", powers(3, 12), 20, 300, 120, 0.5, 3);

  /** Returns 1e-from … 1e-to. */
  public static double[] powers(int from, int to) {
    return IntStream.rangeClosed(from, to)
        .mapToObj(k -> "1e-" + k)
        .flatMapToDouble(text -> DoubleStream.of(Double.parseDouble(text)))
        .toArray();
  }
}
