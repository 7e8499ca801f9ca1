package org.mechservice.result;

import java.util.Arrays;

/**
 * The values that a signal takes in the neighbourhood of each time: those of the broken line
 * through its rows that are at most the time tolerance away.
 */
final class SignalTube {
  /** Rows whose least and largest value are looked up together. */
  private static final int BLOCK = 64;

  private final double[] times;
  private final double[] values;
  private final double reach;
  private final double[] leastOfBlock;
  private final double[] mostOfBlock;

  /** Rows of the neighbourhood last asked for: from the first to before the last. */
  private int from;

  private int to;

  /**
   * @param times of the rows, s, not falling
   * @param values of the signal
   * @param reach the time tolerance, s
   */
  SignalTube(double[] times, double[] values, double reach) {
    this.times = times;
    this.values = values;
    this.reach = reach;
    leastOfBlock = new double[(values.length + BLOCK - 1) / BLOCK];
    mostOfBlock = new double[leastOfBlock.length];
    for (int block = 0; block < leastOfBlock.length; block++) {
      double least = Double.POSITIVE_INFINITY;
      double most = Double.NEGATIVE_INFINITY;
      for (int i = block * BLOCK; i < Math.min(values.length, (block + 1) * BLOCK); i++) {
        least = Math.min(least, values[i]);
        most = Math.max(most, values[i]);
      }
      leastOfBlock[block] = least;
      mostOfBlock[block] = most;
    }
  }

  /**
   * Returns the row of another signal whose point is farthest from this one; a value that is not a
   * number in one signal only is farther than all others; -1 if no row is in the interval of this
   * signal.
   */
  int farthest(double[] otherTimes, double[] otherValues) {
    int farthest = -1;
    double most = -1;
    for (int i = 0; i < otherTimes.length; i++) {
      if (otherTimes[i] >= times[0] - reach && otherTimes[i] <= times[times.length - 1] + reach) {
        double distance = distance(otherTimes[i], otherValues[i]);
        if (distance > most) {
          most = distance;
          farthest = i;
        }
      }
    }
    return farthest;
  }

  /**
   * Returns how far a value lies outside of the values near a time; infinite if one side only is a
   * number.
   */
  double distance(double time, double value) {
    double begin = Math.max(times[0], time - reach);
    double end = Math.min(times[times.length - 1], time + reach);
    double least = Math.min(value(begin), value(end));
    double most = Math.max(value(begin), value(end));
    move(begin, end);
    for (int i = from; i < to; ) {
      boolean whole = i % BLOCK == 0 && i + BLOCK <= to;
      least = Math.min(least, whole ? leastOfBlock[i / BLOCK] : values[i]);
      most = Math.max(most, whole ? mostOfBlock[i / BLOCK] : values[i]);
      i += whole ? BLOCK : 1;
    }
    if (Double.isNaN(value) || Double.isNaN(least)) {
      return Double.isNaN(value) && Double.isNaN(least) ? 0 : Double.POSITIVE_INFINITY;
    }
    return Math.max(0, Math.max(value - most, least - value));
  }

  /** Moves the neighbourhood to the rows between two times; nearly free where times only grow. */
  private void move(double begin, double end) {
    while (from > 0 && times[from - 1] >= begin) {
      from--;
    }
    while (from < times.length && times[from] < begin) {
      from++;
    }
    to = Math.max(to, from);
    while (to > from && times[to - 1] > end) {
      to--;
    }
    while (to < times.length && times[to] <= end) {
      to++;
    }
  }

  /** Returns the interpolated value at a time, outside of the interval that of its end. */
  double value(double time) {
    int at = Arrays.binarySearch(times, time);
    if (at >= 0) {
      return values[at];
    }
    int after = -at - 1;
    if (after == 0 || after == times.length) {
      return values[after == 0 ? 0 : after - 1];
    }
    double part = (time - times[after - 1]) / (times[after] - times[after - 1]);
    return values[after - 1] + part * (values[after] - values[after - 1]);
  }
}
