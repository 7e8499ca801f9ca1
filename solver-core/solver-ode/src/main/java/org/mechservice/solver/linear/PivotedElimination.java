package org.mechservice.solver.linear;

/**
 * Gaussian elimination of an m × n matrix with rows and columns interchanged so that each pivot is
 * the largest element left: which r columns are best found from the others, and by which r rows.
 * Golub and Van Loan, algorithm 3.4.3.
 *
 * <p>Pivots depend on the scaling of rows and columns; the caller scales them to comparable sizes.
 * A workspace for one thread; its methods allocate nothing.
 */
public final class PivotedElimination {
  private final int m;
  private final int n;
  private final double[] a;
  private final int[] row;
  private final int[] column;
  private final double[] pivot;
  private int eliminated;

  /**
   * @param rows m, not negative
   * @param columns n, not negative
   */
  public PivotedElimination(int rows, int columns) {
    m = rows;
    n = columns;
    a = new double[m * n];
    row = new int[m];
    column = new int[n];
    pivot = new double[Math.min(m, n)];
  }

  /**
   * Eliminates until no pivot is left or enough are found.
   *
   * @param matrix m × n row after row; not modified
   * @param steps the most pivots wanted, at most min(m, n)
   * @return the number of pivots found that are finite and not zero
   */
  public int eliminate(double[] matrix, int steps) {
    System.arraycopy(matrix, 0, a, 0, a.length);
    for (int i = 0; i < m; i++) {
      row[i] = i;
    }
    for (int j = 0; j < n; j++) {
      column[j] = j;
    }
    eliminated = 0;
    while (eliminated < steps && bringLargest(eliminated)) {
      Interruption.check();
      eliminateBelow(eliminated);
      eliminated++;
    }
    return eliminated;
  }

  /** Moves the largest element that is left to (k, k); returns whether it is a pivot. */
  private boolean bringLargest(int k) {
    int at = -1;
    double largest = 0;
    for (int i = k; i < m; i++) {
      for (int j = k; j < n; j++) {
        double candidate = Math.abs(a[i * n + j]);
        if (candidate > largest) {
          largest = candidate;
          at = i * n + j;
        }
      }
    }
    if (at < 0 || !Double.isFinite(largest)) {
      return false;
    }
    swapRows(k, at / n);
    swapColumns(k, at % n);
    pivot[k] = largest;
    return true;
  }

  private void eliminateBelow(int k) {
    for (int i = k + 1; i < m; i++) {
      double factor = a[i * n + k] / a[k * n + k];
      a[i * n + k] = factor;
      if (factor != 0) {
        for (int j = k + 1; j < n; j++) {
          a[i * n + j] -= factor * a[k * n + j];
        }
      }
    }
  }

  private void swapRows(int k, int p) {
    for (int j = 0; j < n; j++) {
      double element = a[k * n + j];
      a[k * n + j] = a[p * n + j];
      a[p * n + j] = element;
    }
    int index = row[k];
    row[k] = row[p];
    row[p] = index;
  }

  private void swapColumns(int k, int p) {
    for (int i = 0; i < m; i++) {
      double element = a[i * n + k];
      a[i * n + k] = a[i * n + p];
      a[i * n + p] = element;
    }
    int index = column[k];
    column[k] = column[p];
    column[p] = index;
  }

  /** Returns the row of the matrix that gave pivot k, or stands at k after all interchanges. */
  public int row(int k) {
    return row[k];
  }

  /** Returns the column of the matrix that gave pivot k, or stands at k after all interchanges. */
  public int column(int k) {
    return column[k];
  }

  /** Returns the absolute value of pivot k; they do not grow by more than a factor of two. */
  public double pivot(int k) {
    return pivot[k];
  }

  /** Returns the last pivot over the first, a rough measure of singularity; 1 without pivots. */
  public double lastOverFirst() {
    return eliminated == 0 ? 1 : pivot[eliminated - 1] / pivot[0];
  }
}
