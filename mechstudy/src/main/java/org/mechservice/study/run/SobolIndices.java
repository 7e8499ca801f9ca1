package org.mechservice.study.run;

import java.util.ArrayList;
import java.util.List;

/**
 * The part of an output's variance that each factor causes, from the points of {@link
 * org.mechservice.study.design.Design#indices}: blocks of A, B and, for each factor, A with this
 * factor's value of B.
 *
 * <p>First order, the part that the factor causes alone: mean of f_B (f_AB − f_A) / V (Saltelli and
 * others 2010, table 2, b), with f less its mean. Total, with all interactions: mean of (f_A −
 * f_AB)² / 2 / V (the same, f; Jansen 1999). V is the variance of f_A and f_B. The standard errors
 * are those of ratios of means over independent blocks (delta method); blocks of Sobol's sequence
 * are more even than that, so the errors are rather too large.
 *
 * @param first index of first order
 * @param firstError its standard error
 * @param total index with all interactions
 * @param totalError its standard error
 */
record SobolIndices(double first, double firstError, double total, double totalError) {
  private static final int FEWEST_BLOCKS = 8;

  /**
   * Returns the indices of all factors; none if fewer than 8 blocks have all their values, or all
   * values are equal.
   *
   * @param values of the points in their order, NaN where there is none; not modified
   * @param count how many of them count
   */
  static List<SobolIndices> of(double[] values, int count, int factors) {
    int size = factors + 2;
    List<Integer> blocks = new ArrayList<>();
    double mean = 0;
    for (int at = 0; at + size <= count; at += size) {
      boolean whole = true;
      for (int i = 0; i < size; i++) {
        whole &= !Double.isNaN(values[at + i]);
      }
      if (whole) {
        blocks.add(at);
        mean += (values[at] + values[at + 1] - 2 * mean) / (2.0 * blocks.size());
      }
    }
    int n = blocks.size();
    double[] v = new double[n];
    for (int b = 0; b < n; b++) {
      double a = values[blocks.get(b)] - mean;
      double other = values[blocks.get(b) + 1] - mean;
      v[b] = (a * a + other * other) / 2;
    }
    double variance = n == 0 ? 0 : mean(v);
    List<SobolIndices> indices = new ArrayList<>();
    for (int i = 0; i < factors && n >= FEWEST_BLOCKS && variance > 0; i++) {
      double[] alone = new double[n];
      double[] all = new double[n];
      for (int b = 0; b < n; b++) {
        double a = values[blocks.get(b)] - mean;
        double moved = values[blocks.get(b) + 2 + i] - mean;
        alone[b] = (values[blocks.get(b) + 1] - mean) * (moved - a);
        all[b] = (a - moved) * (a - moved) / 2;
      }
      indices.add(
          new SobolIndices(
              mean(alone) / variance, error(alone, v), mean(all) / variance, error(all, v)));
    }
    return indices;
  }

  private static double mean(double[] x) {
    double sum = 0;
    for (double each : x) {
      sum += each;
    }
    return sum / x.length;
  }

  /** Returns the standard error of mean(u) / mean(v): that of u − r v, over mean(v). */
  private static double error(double[] u, double[] v) {
    double size = mean(v);
    double ratio = mean(u) / size;
    double squares = 0;
    for (int b = 0; b < u.length; b++) {
      double off = u[b] - ratio * v[b];
      squares += off * off;
    }
    return Math.sqrt(squares / (u.length - 1.0) / u.length) / size;
  }
}
