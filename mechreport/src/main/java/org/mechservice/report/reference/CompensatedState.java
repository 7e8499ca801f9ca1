package org.mechservice.report.reference;

import java.util.Optional;

/**
 * A state that is summed up over many steps: what rounding cuts off one sum is added to the next
 * (Kahan 1965).
 */
final class CompensatedState {
  /** The state, length n. */
  final double[] y;

  private final double[] rest;

  CompensatedState(double[] y0) {
    y = y0.clone();
    rest = new double[y0.length];
  }

  /** y = y + d. */
  void add(double[] d) {
    for (int i = 0; i < y.length; i++) {
      double part = d[i] + rest[i];
      double sum = y[i] + part;
      rest[i] = part - (sum - y[i]);
      y[i] = sum;
    }
  }

  /** Hands the state to the problem, which may move it; components it moved begin a new sum. */
  boolean settle(Problem problem, double t) {
    double[] before = y.clone();
    if (!problem.stepEnded(t, y)) {
      return false;
    }
    for (int i = 0; i < y.length; i++) {
      if (y[i] != before[i]) {
        rest[i] = 0;
      }
    }
    return true;
  }

  /** Goes from one time to the next. */
  interface Advance {
    /** Returns whether the state could be taken from one time to another. */
    boolean advance(double from, double to);
  }

  /**
   * Returns the states at times, the first of which is now.
   *
   * @return empty if one of them is not reached
   */
  Optional<double[][]> along(double[] times, Advance code) {
    double[][] states = new double[times.length][];
    states[0] = y.clone();
    for (int k = 1; k < times.length; k++) {
      if (!code.advance(times[k - 1], times[k])) {
        return Optional.empty();
      }
      states[k] = y.clone();
    }
    return Optional.of(states);
  }

  /** Returns the longest step of equal ones that end at a time, none longer than wished. */
  static double equalStep(double left, double wished) {
    return left / Math.max(1, Math.ceil(left / wished * (1 - 1e-9)));
  }
}
