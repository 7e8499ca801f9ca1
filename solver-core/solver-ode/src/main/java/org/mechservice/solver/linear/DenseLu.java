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

  /** Row of A that stands at k after all interchanges, length n. */
  private final int[] rowOf;

  /** 1, or -1 if the interchanges of rows are odd in number. */
  private int parity;

  /** Right-hand side on its way through L, or on its way out, length n. */
  private final double[] partial;

  /**
   * @param dimension n, not negative
   * @throws IllegalArgumentException if it is negative
   */
  public DenseLu(int dimension) {
    super(new DenseLayout(dimension));
    n = dimension;
    lu = new double[n * n];
    inversePivot = new double[n];
    rowOf = new int[n];
    partial = new double[n];
  }

  @Override
  double load(double[] matrix) {
    double norm = 0;
    int i = 0;
    for (; i < n - 3; i += 4) {
      norm = Math.max(norm, loadFour(matrix, i * n));
    }
    for (; i < n; i++) {
      norm = Math.max(norm, loadRow(matrix, i * n));
    }
    return norm;
  }

  /** Copies four rows; returns the largest of their sums, of which none waits for the others. */
  private double loadFour(double[] matrix, int row1) {
    int row2 = row1 + n;
    int row3 = row2 + n;
    int row4 = row3 + n;
    double sum1 = 0;
    double sum2 = 0;
    double sum3 = 0;
    double sum4 = 0;
    for (int j = 0; j < n; j++) {
      double element1 = matrix[row1 + j];
      double element2 = matrix[row2 + j];
      double element3 = matrix[row3 + j];
      double element4 = matrix[row4 + j];
      sum1 += Math.abs(element1);
      sum2 += Math.abs(element2);
      sum3 += Math.abs(element3);
      sum4 += Math.abs(element4);
      lu[row1 + j] = element1;
      lu[row2 + j] = element2;
      lu[row3 + j] = element3;
      lu[row4 + j] = element4;
    }
    return Math.max(Math.max(sum1, sum2), Math.max(sum3, sum4));
  }

  /** Copies a row; returns its sum. */
  private double loadRow(double[] matrix, int row) {
    double sum = 0;
    for (int j = 0; j < n; j++) {
      sum += Math.abs(matrix[row + j]);
      lu[row + j] = matrix[row + j];
    }
    return sum;
  }

  @Override
  int eliminate() {
    parity = 1;
    for (int k = 0; k < n; k++) {
      rowOf[k] = k;
    }
    for (int k = 0; k < n; k++) {
      int p = pivotRow(k);
      double pivot = lu[p * n + k];
      if (!isPivot(pivot)) {
        return k;
      }
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
    parity = -parity;
    int row = rowOf[k];
    rowOf[k] = rowOf[p];
    rowOf[p] = row;
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

  /** Returns the sign of the determinant of the last matrix factored, which is regular. */
  public int signOfDeterminant() {
    int sign = parity;
    for (int k = 0; k < n; k++) {
      sign = inversePivot[k] < 0 ? -sign : sign;
    }
    return sign;
  }

  @Override
  void substitute(double[] b) {
    double[] x = partial;
    int i = 0;
    for (; i < n - 3; i += 4) {
      eliminateFour(b, x, i);
    }
    for (; i < n; i++) {
      x[i] = lessProduct(b[rowOf[i]], i * n, 0, i, x);
    }
    solveUpper(b, x);
  }

  /**
   * Solves U b = x from below. Each row needs the unknown just found first: taken from the array it
   * would come later by the time of a store.
   */
  private void solveUpper(double[] b, double[] x) {
    double found = 0;
    for (int i = n - 1; i >= 0; i--) {
      double start = i == n - 1 ? x[i] : x[i] - lu[i * n + i + 1] * found;
      found = lessProduct(start, i * n, i + 2, n, b) * inversePivot[i];
      b[i] = found;
    }
  }

  /** Rows i to i + 3 of L at once: none waits for the sums of the others. */
  private void eliminateFour(double[] b, double[] x, int i) {
    int row1 = i * n;
    int row2 = row1 + n;
    int row3 = row2 + n;
    int row4 = row3 + n;
    double x1 = b[rowOf[i]];
    double x2 = b[rowOf[i + 1]];
    double x3 = b[rowOf[i + 2]];
    double x4 = b[rowOf[i + 3]];
    for (int j = 0; j < i; j++) {
      double known = x[j];
      x1 -= lu[row1 + j] * known;
      x2 -= lu[row2 + j] * known;
      x3 -= lu[row3 + j] * known;
      x4 -= lu[row4 + j] * known;
    }
    x2 -= lu[row2 + i] * x1;
    x3 = x3 - lu[row3 + i] * x1 - lu[row3 + i + 1] * x2;
    x4 = x4 - lu[row4 + i] * x1 - lu[row4 + i + 1] * x2 - lu[row4 + i + 2] * x3;
    x[i] = x1;
    x[i + 1] = x2;
    x[i + 2] = x3;
    x[i + 3] = x4;
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
    System.arraycopy(b, 0, partial, 0, n);
    for (int k = 0; k < n; k++) {
      b[rowOf[k]] = partial[k];
    }
  }
}
