package org.mechservice.solver.simulation;

import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The times of the rows: the start, then every multiple of the output distance, then the end.
 *
 * <p>Times have one rounding error if the distance divides a second, so that 7 · 0.01 s is written
 * 0.07.
 */
final class OutputTimes {
  /** A distance this close to dividing a second, relatively, is meant to divide it. */
  private static final double DIVIDES = 1e-12;

  /** A last row this close to the end, relative to the distance, is the end. */
  private static final double AT_END = 1e-9;

  private final double start;
  private final double end;
  private final double step;
  private final double perSecond;
  private final long count;

  OutputTimes(RunSettings settings) {
    start = settings.tStart();
    end = settings.tEnd();
    step = settings.tStep();
    double rows = Math.rint(1 / step);
    perSecond = Math.abs(rows * step - 1) < DIVIDES ? rows : 0;
    count = end == start ? 1 : (long) Math.ceil((end - start) / step - AT_END) + 1;
  }

  /**
   * Checks the times of a run.
   *
   * @throws IllegalArgumentException S-062 naming the one that cannot be used
   */
  static void requireUsable(RunSettings settings) {
    require(Double.isFinite(settings.tStart()), "start time", settings.tStart(), "finite");
    require(
        Double.isFinite(settings.tEnd()) && settings.tEnd() >= settings.tStart(),
        "end time",
        settings.tEnd(),
        "finite and not before the start at " + settings.tStart() + " s");
    require(
        settings.tStep() > 0 && Double.isFinite(settings.tStep()),
        "output step",
        settings.tStep(),
        "positive and finite");
  }

  private static void require(boolean met, String what, double value, String expected) {
    if (!met) {
      throw new IllegalArgumentException(
          MessageCode.TIME_SETTING
              + " the "
              + what
              + " is "
              + value
              + " s; it must be "
              + expected);
    }
  }

  /** Returns the number of rows. */
  long count() {
    return count;
  }

  /** Returns the time of row {@code index}, s; infinite after the last one. */
  double time(long index) {
    if (index >= count) {
      return Double.POSITIVE_INFINITY;
    }
    if (index == count - 1) {
      return end;
    }
    return start + (perSecond > 0 ? index / perSecond : index * step);
  }
}
