package org.mechservice.solver.linear;

/**
 * LU factors of a dense matrix with partial pivoting, P A = L U. Golub and Van Loan, algorithm
 * 3.4.1, with rows as the inner loop.
 */
public final class DenseLu extends LuFactors {
  private final int n;

  /** L below the diagonal, its own being 1, and U above it, row after row, length n². */
  private final double[] lu;

  /** 1 / U_kk, length n. */
  private final double[] inversePivot;

  /** Row that was interchanged with row k at stage k, length n. */
  private final int[] interchange;

  /**
   * @param dimension n, not negative
   * @throws IllegalArgumentException if it is negative
   */
  public DenseLu(int dimension) {
    super(new DenseLayout(dimension));
    n = dimension;
    lu = new double[n * n];
    inversePivot = new double[n];
    interchange = new int[n];
  }

  @Override
  double load(double[] matrix) {
    System.arraycopy(matrix, 0, lu, 0, lu.length);
    double norm = 0;
    for (int i = 0; i < n; i++) {
      double sum = 0;
      for (int ij = i * n; ij < i * n + n; ij++) {
        sum += Math.abs(lu[ij]);
      }
      norm = Math.max(norm, sum);
    }
    return norm;
  }

  @Override
  int eliminate() {
    for (int k = 0; k < n; k++) {
      int p = pivotRow(k);
      double pivot = lu[p * n + k];
      if (!isPivot(pivot)) {
        return k;
      }
      interchange[k] = p;
      inversePivot[k] = 1 / pivot;
      if (p != k) {
        swapRows(k, p);
      }
      for (int i = k + 1; i < n; i++) {
        eliminateRow(k, i);
      }
    }
    return NONSINGULAR;
  }

  private int pivotRow(int k) {
    int p = k;
    double largest = Math.abs(lu[k * n + k]);
    for (int i = k + 1; i < n; i++) {
      double candidate = Math.abs(lu[i * n + k]);
      if (candidate > largest) {
        largest = candidate;
        p = i;
      }
    }
    return p;
  }

  private void swapRows(int k, int p) {
    for (int j = 0; j < n; j++) {
      double a = lu[k * n + j];
      lu[k * n + j] = lu[p * n + j];
      lu[p * n + j] = a;
    }
  }

  /** Row i minus L_ik times row k, from column k on. */
  private void eliminateRow(int k, int i) {
    int ofK = k * n;
    int ofI = i * n;
    double factor = lu[ofI + k] * inversePivot[k];
    lu[ofI + k] = factor;
    if (factor == 0) {
      return;
    }
    for (int j = k + 1; j < n; j++) {
      lu[ofI + j] -= factor * lu[ofK + j];
    }
  }

  @Override
  void substitute(double[] b) {
    for (int k = 0; k < n; k++) {
      swap(b, k);
    }
    int i = 0;
    for (; i < n - 1; i += 2) {
      eliminatePair(b, i);
    }
    if (i < n) {
      b[i] = lessProduct(b[i], i * n, 0, i, b);
    }
    for (i = n - 1; i >= 0; i--) {
      b[i] = lessProduct(b[i], i * n, i + 1, n, b) * inversePivot[i];
    }
  }

  /** Rows i and i + 1 of L at once: neither waits for the sums of the other. */
  private void eliminatePair(double[] b, int i) {
    int row = i * n;
    int below = row + n;
    double first = b[i];
    double second = b[i + 1];
    for (int j = 0; j < i; j++) {
      double known = b[j];
      first -= lu[row + j] * known;
      second -= lu[below + j] * known;
    }
    b[i] = first;
    b[i + 1] = second - lu[below + i] * first;
  }

  private double lessProduct(double start, int row, int from, int end, double[] b) {
    double sum = start;
    for (int j = from; j < end; j++) {
      sum -= lu[row + j] * b[j];
    }
    return sum;
  }

  @Override
  void substituteTransposed(double[] b) {
    for (int i = 0; i < n; i++) {
      b[i] *= inversePivot[i];
      for (int j = i + 1; j < n; j++) {
        b[j] -= lu[i * n + j] * b[i];
      }
    }
    for (int i = n - 1; i > 0; i--) {
      for (int j = 0; j < i; j++) {
        b[j] -= lu[i * n + j] * b[i];
      }
    }
    for (int k = n - 1; k >= 0; k--) {
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
