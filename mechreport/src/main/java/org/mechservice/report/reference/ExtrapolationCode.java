package org.mechservice.report.reference;

import java.util.Optional;

/**
 * Gragg, Bulirsch and Stoer's extrapolation of the explicit midpoint rule with a fixed number of
 * columns k, order 2k (Hairer, Nørsett &amp; Wanner I, 1993, §II.9), for nonstiff problems:
 * sequence 2, 4, 6, …, without smoothing, error from the last two of the diagonal.
 */
public final class ExtrapolationCode implements ReferenceCode {
  private final int columns;

  /**
   * @param columns k, from 2
   */
  public ExtrapolationCode(int columns) {
    this.columns = columns;
  }

  @Override
  public String name() {
    return "Gragg-Bulirsch-Stoer extrapolation, order " + 2 * columns;
  }

  @Override
  public Optional<double[][]> solve(
      Problem problem, double[] times, double[] y0, double tolerance, long deadline) {
    CompensatedState state = new CompensatedState(y0);
    Solution steps = new Solution(problem, state, tolerance);
    double firstStep = (times[times.length - 1] - times[0]) / 100;
    return new PhaseIntegration(problem, state, steps, tolerance, deadline)
        .through(times, firstStep);
  }

  /** One problem in progress. */
  private final class Solution implements PhaseIntegration.Steps {
    private final int n;
    private final Problem problem;
    private final double tolerance;
    private final CompensatedState state;
    private final double[] f0;
    private final double[][] row;
    private final double[] before;

    Solution(Problem problem, CompensatedState state, double tolerance) {
      this.problem = problem;
      this.tolerance = tolerance;
      this.state = state;
      n = state.y.length;
      f0 = new double[n];
      row = new double[columns][n];
      before = new double[n];
    }

    @Override
    public double[] increment() {
      return row[0];
    }

    @Override
    public double next(double step, double error, boolean accepted) {
      double ratio = tolerance / Math.max(error, 1e-300);
      double factor = 0.8 * Math.pow(ratio, 1.0 / (2 * columns - 1));
      return step * Math.max(0.2, Math.min(accepted ? 3 : 0.7, factor));
    }

    /**
     * Leaves the increment of y in row[0]; returns the weighted error, infinite if f has no value.
     */
    @Override
    public double attempt(double t, double step) {
      if (!problem.derivative(t, state.y, f0)) {
        return Double.POSITIVE_INFINITY;
      }
      for (int j = 0; j < columns; j++) {
        System.arraycopy(row[0], 0, before, 0, n);
        if (!midpoint(t, step, 2 * (j + 1), row[j])) {
          return Double.POSITIVE_INFINITY;
        }
        // Aitken and Neville: row[i] becomes the entry that uses sequences i … j.
        for (int i = j - 1; i >= 0; i--) {
          double ratio = (double) (j + 1) / (i + 1);
          double divisor = ratio * ratio - 1;
          for (int k = 0; k < n; k++) {
            row[i][k] = row[i + 1][k] + (row[i + 1][k] - row[i][k]) / divisor;
          }
        }
      }
      double error = 0;
      for (int k = 0; k < n; k++) {
        double size = Math.abs(row[0][k] - before[k]) / (1 + Math.abs(state.y[k]));
        error = size >= 0 ? Math.max(error, size) : Double.POSITIVE_INFINITY;
      }
      return error;
    }

    /** Increment of y by the midpoint rule with an even number of parts. */
    private boolean midpoint(double t, double step, int parts, double[] increment) {
      double part = step / parts;
      double[] older = new double[n];
      double[] newer = new double[n];
      double[] y = new double[n];
      double[] yDot = new double[n];
      for (int k = 0; k < n; k++) {
        newer[k] = part * f0[k];
      }
      for (int m = 1; m < parts; m++) {
        for (int k = 0; k < n; k++) {
          y[k] = state.y[k] + newer[k];
        }
        if (!problem.derivative(t + m * part, y, yDot)) {
          return false;
        }
        for (int k = 0; k < n; k++) {
          double next = older[k] + 2 * part * yDot[k];
          older[k] = newer[k];
          newer[k] = next;
        }
      }
      System.arraycopy(newer, 0, increment, 0, n);
      return true;
    }
  }
}
