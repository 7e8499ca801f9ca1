package org.mechservice.solver.analysis;

import java.util.stream.IntStream;
import org.mechservice.solver.linear.spectrum.SingularValues;

/**
 * The linear equations of one Newton step, J x = −r, with as many conditions and unknowns as there
 * may be. Rows and columns are scaled by the derivatives; where they are dependent, the step is the
 * smallest one by singular values. Immutable.
 */
final class ScaledStep {
  /** Singular value, as a fraction of the largest, below which equations are dependent. */
  private static final double DEPENDENT = 1e-8;

  /** Part of a unit vector outside the range above which an equation belongs to a dependence. */
  private static final double BELONGS = 0.1;

  private final int m;
  private final int n;
  private final double[] scale;

  /** Change of a condition that unknowns cause in their scales; that of its value if none do. */
  private final double[] row;

  private final double[] column;
  private final double[] matrix;
  private final SingularValues singular;
  private final int rank;

  /**
   * Scales and decomposes the equations of a step.
   *
   * @param slopes derivatives of the conditions by the unknowns, row by row; not modified
   * @param r residuals; not modified
   * @param values of the conditions, which the residuals are small beside; not modified
   * @param scale of the unknowns; not modified
   */
  ScaledStep(double[] slopes, double[] r, double[] values, double[] scale) {
    m = r.length;
    n = scale.length;
    this.scale = scale.clone();
    row = new double[m];
    column = new double[n];
    singular = new SingularValues(m, n);
    matrix = slopes.clone();
    for (int i = 0; i < m; i++) {
      for (int j = 0; j < n; j++) {
        row[i] = Math.max(row[i], Math.abs(slopes[i * n + j]) * scale[j]);
      }
      double rounding = 1e-10 * (Math.abs(r[i]) + Math.abs(values[i]));
      row[i] = row[i] <= rounding ? Math.max(rounding, Double.MIN_NORMAL) : row[i];
    }
    for (int j = 0; j < n; j++) {
      for (int i = 0; i < m; i++) {
        matrix[i * n + j] *= scale[j] / row[i];
        column[j] = Math.max(column[j], Math.abs(matrix[i * n + j]));
      }
      column[j] = column[j] <= DEPENDENT ? 1 : column[j];
    }
    for (int i = 0; i < m * n; i++) {
      matrix[i] /= column[i % n];
    }
    singular.decompose(matrix);
    int independent = 0;
    while (independent < Math.min(m, n)
        && singular.value(independent) > DEPENDENT * singular.value(0)) {
      independent++;
    }
    rank = independent;
  }

  /** Returns the largest residual, as the change of unknowns that it needs, in their scales. */
  double residual(double[] r) {
    double largest = 0;
    for (int i = 0; i < m; i++) {
      largest = Math.max(largest, Math.abs(r[i]) / row[i]);
    }
    return largest;
  }

  /** Returns the sum of the squares of the scaled residuals. */
  double square(double[] r) {
    double sum = 0;
    for (int i = 0; i < m; i++) {
      sum += r[i] / row[i] * (r[i] / row[i]);
    }
    return sum;
  }

  /** Writes the smallest step that brings the residuals to zero as well as can be. */
  void step(double[] r, double[] step) {
    double[] right = new double[m];
    for (int i = 0; i < m; i++) {
      right[i] = -r[i] / row[i];
    }
    singular.solve(rank, right, step);
    for (int j = 0; j < n; j++) {
      step[j] *= scale[j] / column[j];
    }
  }

  /** Returns the condition whose scaled residual is largest. */
  int worst(double[] r) {
    int worst = 0;
    for (int i = 1; i < m; i++) {
      worst = Math.abs(r[i]) / row[i] > Math.abs(r[worst]) / row[worst] ? i : worst;
    }
    return worst;
  }

  /** Returns the unknowns that the conditions do not determine. */
  int[] undetermined() {
    IntStream.Builder found = IntStream.builder();
    double[] x = new double[n];
    double[] right = new double[m];
    for (int j = 0; j < n && rank < n; j++) {
      for (int i = 0; i < m; i++) {
        right[i] = matrix[i * n + j];
      }
      singular.solve(rank, right, x);
      if (1 - x[j] > BELONGS) {
        found.add(j);
      }
    }
    return found.build().toArray();
  }

  /** Returns the conditions that depend on each other, or on no unknown. */
  int[] dependent() {
    IntStream.Builder found = IntStream.builder();
    double[] x = new double[n];
    for (int i = 0; i < m && rank < m; i++) {
      double[] unit = new double[m];
      unit[i] = 1;
      singular.solve(rank, unit, x);
      double reached = 0;
      for (int j = 0; j < n; j++) {
        reached += matrix[i * n + j] * x[j];
      }
      if (1 - reached > BELONGS) {
        found.add(i);
      }
    }
    return found.build().toArray();
  }
}
