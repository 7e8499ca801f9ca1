package org.mechservice.study.optimise;

/**
 * The triangle R of J = Q R and Qᵀ r, for many more rows than columns: rows are taken some at a
 * time and merged into the triangle by Householder reflections, so that what is worked on stays in
 * the processor's cache (Golub and Van Loan 2013, §5.2 and §6.5.3).
 *
 * @param triangle R, n by n, row after row, zero below its diagonal
 * @param right Qᵀ r, n numbers
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record TallFactors(double[][] triangle, double[] right) {
  /** Rows that are merged at once. */
  private static final int BLOCK = 64;

  /**
   * Factors derivatives.
   *
   * @param jacobian m rows of n numbers; not modified
   * @param residuals r, m numbers; not modified
   */
  public static TallFactors of(double[][] jacobian, double[] residuals) {
    int m = jacobian.length;
    int n = m == 0 ? 0 : jacobian[0].length;
    // column after column; the last one is r
    double[][] upper = new double[n + 1][n];
    double[][] block = new double[n + 1][BLOCK];
    for (int first = 0; first < m; first += BLOCK) {
      int rows = Math.min(BLOCK, m - first);
      for (int i = 0; i < rows; i++) {
        double[] row = jacobian[first + i];
        for (int j = 0; j < n; j++) {
          block[j][i] = row[j];
        }
        block[n][i] = residuals[first + i];
      }
      merge(upper, block, rows, n);
    }
    double[][] triangle = new double[n][n];
    for (int i = 0; i < n; i++) {
      for (int j = i; j < n; j++) {
        triangle[i][j] = upper[j][i];
      }
    }
    return new TallFactors(triangle, upper[n]);
  }

  /** Reflects the rows of a block into the triangle, column after column. */
  private static void merge(double[][] upper, double[][] block, int rows, int n) {
    for (int k = 0; k < n; k++) {
      double[] v = block[k];
      double below = dot(v, v, rows);
      if (below == 0) {
        continue;
      }
      double head = upper[k][k];
      double norm = -Math.copySign(Math.sqrt(head * head + below), head);
      double first = head - norm;
      upper[k][k] = norm;
      // I − 2 w wᵀ / wᵀw with w = [first; v]: wᵀw = 2 norm (norm − head) = −2 norm first
      double factor = -1 / (norm * first);
      for (int j = k + 1; j <= n; j++) {
        double[] column = block[j];
        double along = factor * (first * upper[j][k] + dot(v, column, rows));
        upper[j][k] -= along * first;
        for (int i = 0; i < rows; i++) {
          column[i] -= along * v[i];
        }
      }
    }
  }

  /** Four sums side by side: a single one would wait for each addition. */
  private static double dot(double[] a, double[] b, int length) {
    double s0 = 0;
    double s1 = 0;
    double s2 = 0;
    double s3 = 0;
    int i = 0;
    for (; i + 3 < length; i += 4) {
      s0 += a[i] * b[i];
      s1 += a[i + 1] * b[i + 1];
      s2 += a[i + 2] * b[i + 2];
      s3 += a[i + 3] * b[i + 3];
    }
    for (; i < length; i++) {
      s0 += a[i] * b[i];
    }
    return s0 + s1 + (s2 + s3);
  }
}
