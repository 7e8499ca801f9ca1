package org.mechservice.report.reference;

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
}
