package org.mechservice.solver.linear.front;

import java.util.Arrays;

/**
 * Rows of L and D that one front adds to P A Pᵀ = L D Lᵀ, and the solution by them: {@link
 * #forward} front by front, then {@link #divide} and {@link #backward} in the opposite order.
 */
final class FrontFactor {
  static final FrontFactor NONE = new FrontFactor(new int[0], 0, new double[0], new double[0]);

  private final int[] rows;
  private final int pivots;

  /** Columns of L, one behind the other, below the diagonal, which is 1. */
  private final double[] l;

  /** Two numbers for each pivot's row: its diagonal element, and that beside it if two rows. */
  private final double[] d;

  /**
   * Makes a factor.
   *
   * @param rows unknowns of the front, those with pivots first; kept
   * @param pivots number of rows with pivots
   * @param l columns of L below the diagonal; kept
   * @param d two numbers for each pivot's row; copied
   */
  FrontFactor(int[] rows, int pivots, double[] l, double[] d) {
    this.rows = rows;
    this.pivots = pivots;
    this.l = l;
    this.d = Arrays.copyOf(d, 2 * pivots);
  }

  /** Returns the number of rows with pivots. */
  int pivots() {
    return pivots;
  }

  /** Solves L y = b for the rows of this front; {@code b} is overwritten. */
  void forward(double[] b) {
    int at = 0;
    for (int k = 0; k < pivots; k++) {
      double x = b[rows[k]];
      for (int r = k + 1; r < rows.length; r++) {
        b[rows[r]] -= l[at++] * x;
      }
    }
  }

  /** Solves D z = y for the rows of this front; {@code b} is overwritten. */
  void divide(double[] b) {
    int k = 0;
    while (k < pivots) {
      int row = rows[k];
      double a = d[2 * k];
      double cross = d[2 * k + 1];
      if (cross == 0) {
        b[row] /= a;
        k++;
      } else {
        int next = rows[k + 1];
        double other = d[2 * k + 2];
        double det = a * other - cross * cross;
        double x = (other * b[row] - cross * b[next]) / det;
        b[next] = (a * b[next] - cross * b[row]) / det;
        b[row] = x;
        k += 2;
      }
    }
  }

  /** Solves Lᵀ x = z for the rows of this front; {@code b} is overwritten. */
  void backward(double[] b) {
    int at = l.length;
    for (int k = pivots - 1; k >= 0; k--) {
      double sum = b[rows[k]];
      for (int r = rows.length - 1; r > k; r--) {
        sum -= l[--at] * b[rows[r]];
      }
      b[rows[k]] = sum;
    }
  }
}
