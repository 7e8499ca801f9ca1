package org.mechservice.solver.ode.switching;

import org.mechservice.solver.ode.SavedState;

/**
 * The solution sampled every few steps, as divided differences over the latest places. Time is
 * counted in units of about the interval, lest its powers overflow.
 */
final class SampledHistory {
  /** Places that a difference goes back over, at most: those of order 5 take six. */
  private static final int MOST = 6;

  private final int stride;

  /** Unit of time, a power of two. */
  private double unit = 1;

  /** Steps since the latest place. */
  private int steps;

  private int count;

  /** The latest places, that of index 0 last. */
  private final double[] time = new double[MOST];

  /** y[t_0, …, t_m] in row m. */
  private double[][] difference = new double[MOST][0];

  private double[] newer = {};
  private double[] older = {};

  /**
   * @param stride steps from one place to the next
   */
  SampledHistory(int stride) {
    this.stride = stride;
  }

  /**
   * @param interval length of the problem
   */
  void prepare(int dimension, double interval) {
    unit = interval == 0 ? 1 : Math.scalb(1.0, Math.getExponent(interval));
    difference = new double[MOST][dimension];
    newer = new double[dimension];
    older = new double[dimension];
    begin();
  }

  /** Forgets all places. */
  void begin() {
    steps = 0;
    count = 0;
  }

  /** Takes note of a step; returns whether its end is a new place. */
  boolean record(double t, double[] y) {
    steps++;
    if (steps < stride) {
      return false;
    }
    steps = 0;
    System.arraycopy(time, 0, time, 1, MOST - 1);
    time[0] = t;
    count = Math.min(count + 1, MOST);
    System.arraycopy(y, 0, newer, 0, y.length);
    for (int m = 0; m < count; m++) {
      double[] swapped = difference[m];
      difference[m] = newer;
      newer = older;
      older = swapped;
      if (m + 1 < count) {
        divide(difference[m], older, 1 / ((t - time[m + 1]) / unit));
      }
    }
    return true;
  }

  /** Forms the next difference from those of the order below. */
  private void divide(double[] now, double[] before, double inverse) {
    for (int l = 0; l < now.length; l++) {
      newer[l] = (now[l] - before[l]) * inverse;
    }
  }

  /** Returns how many places there are, 6 at most. */
  int count() {
    return count;
  }

  /** Returns the mean length of the steps between the places; 0 if there are not two. */
  double meanStep() {
    return count < 2 ? 0 : Math.abs(time[0] - time[count - 1]) / ((count - 1) * stride);
  }

  /** Returns the unit of time that differences are divided by. */
  double unit() {
    return unit;
  }

  /** Returns y[t_0, …, t_m] over the latest m + 1 places. */
  double[] difference(int m) {
    return difference[m];
  }

  /** Carries the places over. */
  void transfer(SavedState state) {
    steps = state.integer(steps);
    count = state.integer(count);
    state.numbers(time);
    for (double[] row : difference) {
      state.numbers(row);
    }
  }
}
