package org.mechservice.solver.ode.backward;

import java.util.Arrays;

/**
 * The matrix R(r) U that turns backward differences over steps h into those over steps r h.
 *
 * <pre>
 * R_ij(r) = Π_{l=1..i} (l − 1 − j r) / l,  U = R(1),  i, j = 1 … k
 * </pre>
 *
 * It is lower triangular: the m-th difference of a polynomial depends on its differences of orders
 * m and higher, whatever the step. U is its own inverse, U_ij = (−1)^i (j over i). Shampine and
 * Reichelt 1997, §2.
 */
final class RescalingMatrix {
  private static final int LENGTH = BackwardFormulas.HIGHEST_ORDER + 1;
  private static final double[][] U = new double[LENGTH][LENGTH];

  static {
    Arrays.fill(U[0], 1);
    for (int i = 1; i < LENGTH; i++) {
      formRow(U, i, 1, LENGTH - 1);
    }
  }

  private final double[][] r = new double[LENGTH][LENGTH];
  private final double[][] product = new double[LENGTH][LENGTH];
  private int size;

  RescalingMatrix() {
    Arrays.fill(r[0], 1);
  }

  /** Forms the matrix of size k. */
  void prepare(double ratio, int k) {
    size = k;
    for (int i = 1; i <= k; i++) {
      formRow(r, i, ratio, k);
      for (int j = 1; j <= i; j++) {
        product[i][j] = product(i, j);
      }
    }
  }

  /** Returns (R U)_ij, j ≤ i; 0 beyond the size of the matrix. */
  double element(int i, int j) {
    return i <= size ? product[i][j] : 0;
  }

  private double product(int i, int j) {
    double sum = 0;
    for (int l = 1; l <= j; l++) {
      sum += r[i][l] * U[l][j];
    }
    return sum;
  }

  /** Forms row i of R from the one above; row 0 is all ones. */
  private static void formRow(double[][] matrix, int i, double ratio, int k) {
    double[] above = matrix[i - 1];
    double[] row = matrix[i];
    for (int j = 1; j <= k; j++) {
      row[j] = above[j] * ((i - 1 - j * ratio) / i);
    }
  }
}
