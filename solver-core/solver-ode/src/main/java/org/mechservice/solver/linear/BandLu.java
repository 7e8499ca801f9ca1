package org.mechservice.solver.linear;

import java.util.Arrays;

/**
 * LU factors of a band matrix with partial pivoting. Row interchanges may widen U to l + u
 * diagonals above the main one, for which there is room. Golub and Van Loan, algorithm 4.3.1 with
 * pivoting.
 */
public final class BandLu extends LuFactors {
  private final int n;
  private final int lower;

  /** Number of diagonals of U above the main one, l + u. */
  private final int reach;

  /** Number of places per row, 2l + u + 1. */
  private final int width;

  /** Element (i, j) of L or U at i width + j − i + l, −l ≤ j − i ≤ reach. */
  private final double[] lu;

  /** 1 / U_kk, length n. */
  private final double[] inversePivot;

  /** Row that was interchanged with row k at stage k, length n. */
  private final int[] interchange;

  /**
   * @param layout size of matrix and band
   */
  public BandLu(BandLayout layout) {
    super(layout);
    n = layout.dimension();
    lower = layout.lower();
    reach = layout.lower() + layout.upper();
    width = lower + reach + 1;
    lu = new double[n * width];
    inversePivot = new double[n];
    interchange = new int[n];
  }

  private int at(int row, int column) {
    return row * width + column - row + lower;
  }

  private int lastColumn(int row) {
    return Math.min(n - 1, row + reach);
  }

  private int lastRow(int column) {
    return Math.min(n - 1, column + lower);
  }

  @Override
  double load(double[] matrix) {
    int places = reach + 1;
    double norm = 0;
    Arrays.fill(lu, 0);
    for (int i = 0; i < n; i++) {
      double sum = 0;
      int last = Math.min(n - 1, i + reach - lower);
      for (int j = Math.max(0, i - lower); j <= last; j++) {
        double element = matrix[i * places + j - i + lower];
        lu[at(i, j)] = element;
        sum += Math.abs(element);
      }
      norm = Math.max(norm, sum);
    }
    return norm;
  }

  @Override
  int eliminate() {
    for (int k = 0; k < n; k++) {
      int p = pivotRow(k);
      double pivot = lu[at(p, k)];
      if (!isPivot(pivot)) {
        return k;
      }
      interchange[k] = p;
      inversePivot[k] = 1 / pivot;
      if (p != k) {
        swapRows(k, p);
      }
      for (int i = k + 1; i <= lastRow(k); i++) {
        eliminateRow(k, i);
      }
    }
    return NONSINGULAR;
  }

  private int pivotRow(int k) {
    int p = k;
    double largest = Math.abs(lu[at(k, k)]);
    for (int i = k + 1; i <= lastRow(k); i++) {
      double candidate = Math.abs(lu[at(i, k)]);
      if (candidate > largest) {
        largest = candidate;
        p = i;
      }
    }
    return p;
  }

  /** Interchanges what is left of two rows; factors of earlier columns stay where they are. */
  private void swapRows(int k, int p) {
    for (int j = k; j <= lastColumn(k); j++) {
      double a = lu[at(k, j)];
      lu[at(k, j)] = lu[at(p, j)];
      lu[at(p, j)] = a;
    }
  }

  /** Row i minus L_ik times row k, from column k on. */
  private void eliminateRow(int k, int i) {
    double factor = lu[at(i, k)] * inversePivot[k];
    lu[at(i, k)] = factor;
    if (factor == 0) {
      return;
    }
    int ofK = at(k, k) - k;
    int ofI = at(i, k) - k;
    for (int j = k + 1; j <= lastColumn(k); j++) {
      lu[ofI + j] -= factor * lu[ofK + j];
    }
  }

  @Override
  void substitute(double[] b) {
    for (int k = 0; k < n; k++) {
      swap(b, k);
      for (int i = k + 1; i <= lastRow(k); i++) {
        b[i] -= lu[at(i, k)] * b[k];
      }
    }
    for (int i = n - 1; i >= 0; i--) {
      double sum = b[i];
      int ofI = at(i, 0);
      for (int j = i + 1; j <= lastColumn(i); j++) {
        sum -= lu[ofI + j] * b[j];
      }
      b[i] = sum * inversePivot[i];
    }
  }

  @Override
  void substituteTransposed(double[] b) {
    for (int i = 0; i < n; i++) {
      b[i] *= inversePivot[i];
      for (int j = i + 1; j <= lastColumn(i); j++) {
        b[j] -= lu[at(i, j)] * b[i];
      }
    }
    for (int k = n - 1; k >= 0; k--) {
      for (int i = k + 1; i <= lastRow(k); i++) {
        b[k] -= lu[at(i, k)] * b[i];
      }
      swap(b, k);
    }
  }

  private void swap(double[] b, int k) {
    int p = interchange[k];
    double part = b[k];
    b[k] = b[p];
    b[p] = part;
  }
}
