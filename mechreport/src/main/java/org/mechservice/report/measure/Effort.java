package org.mechservice.report.measure;

import java.util.Arrays;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * The amount of measurement for a report: how much is measured where time is no matter, and what
 * the whole may take. A scene of usual size does not come near that budget; of a large mechanism
 * the report measures what fits into it and says what it left out.
 *
 * @param name for the page
 * @param tolerances relative tolerances, loosest first
 * @param limitSeconds processor time after which a single run is stopped, s
 * @param fewestRepeats timed runs of a point that takes long
 * @param timingSeconds for all timed runs together, s, as far as {@code fewestRepeats} allows
 * @param referenceSeconds for one solution of the reference, s
 * @param warmSeconds of rounds over all points that are compared with those before them, to see
 *     whether all is warm, s; 0 for no warm-up
 * @param freshStarts first runs in a Java machine of their own, per method
 * @param budgetSeconds wall-clock time for the whole report, s; infinite for no bound
 */
@SuppressWarnings("ArrayRecordComponent") // constants, not changed
public record Effort(
    String name,
    double[] tolerances,
    double limitSeconds,
    int fewestRepeats,
    double timingSeconds,
    double referenceSeconds,
    double warmSeconds,
    int freshStarts,
    double budgetSeconds) {
  /** Timed runs per point at most. */
  public static final int REPEATS = 11;

  /**
   * Ratio to the fastest method at the same tolerance above which the exact time of a run is
   * irrelevant.
   */
  public static final double SENSELESS = 100;

  /** What takes less, s, is measured to the end however slow it is beside the others. */
  public static final double CHEAP_SECONDS = 1;

  private static final double TYPICAL = 1e-5;

  /** About a minute; three minutes at most for large mechanisms. */
  public static final Effort QUICK =
      new Effort("quick", new double[] {1e-3, 1e-5, 1e-7, 1e-9}, 1, 3, 12, 4, 1, 1, 180);

  /**
   * Tolerances from 1e-3 to 1e-12, every point timed eleven times; a quarter of an hour at most.
   */
  public static final Effort FULL =
      new Effort("full", powers(3, 12), 20, REPEATS, Double.POSITIVE_INFINITY, 120, 3, 5, 900);

  /**
   * Returns the same effort with another time for the whole report.
   *
   * @param seconds of wall-clock time, positive; infinite for no bound
   */
  public Effort withBudget(double seconds) {
    return new Effort(
        name,
        tolerances,
        limitSeconds,
        fewestRepeats,
        timingSeconds,
        referenceSeconds,
        warmSeconds,
        freshStarts,
        seconds);
  }

  /**
   * Returns the tolerance that first runs and shares of time are measured at: 1e-5, or the next.
   */
  public double typicalTolerance() {
    return Arrays.stream(tolerances)
        .filter(tolerance -> tolerance <= TYPICAL)
        .max()
        .orElse(tolerances[tolerances.length - 1]);
  }

  /** Returns 1e-from … 1e-to. */
  public static double[] powers(int from, int to) {
    return IntStream.rangeClosed(from, to)
        .mapToObj(k -> "1e-" + k)
        .flatMapToDouble(text -> DoubleStream.of(Double.parseDouble(text)))
        .toArray();
  }
}
