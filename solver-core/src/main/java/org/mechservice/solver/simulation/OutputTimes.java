package org.mechservice.solver.simulation;

import org.mechservice.solver.api.RunSettings;

/**
 * The times of the rows: the start, then every multiple of the output distance, then the end.
 *
 * <p>Times are formed by one rounding where the distance divides a second, so that 7 · 0.01 s is
 * written 0.07.
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

  /** Returns the number of rows. */
  long count() {
    return count;
  }

  /** Returns the time of row {@code index}, s; infinite behind the last one. */
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
