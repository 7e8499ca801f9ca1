package org.mechservice.report.reference;

import java.util.Arrays;

/**
 * A state summed over many steps with compensation: the rounding error of each sum is added to the
 * next (Kahan 1965).
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

  /** Passes the state to the problem, which may change it; changed components begin a new sum. */
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

  /** Sets another state. */
  void set(double[] other) {
    System.arraycopy(other, 0, y, 0, y.length);
    Arrays.fill(rest, 0);
  }

  /** Returns the longest step of equal ones that end at a time, none longer than wished. */
  static double equalStep(double left, double wished) {
    return left / Math.max(1, Math.ceil(left / wished * (1 - 1e-9)));
  }
}
