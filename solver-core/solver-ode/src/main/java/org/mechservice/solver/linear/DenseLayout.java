package org.mechservice.solver.linear;

/**
 * All elements, row after row: A_ij at i n + j.
 *
 * @param dimension n, not negative
 */
public record DenseLayout(int dimension) implements MatrixLayout {
  /**
   * @throws IllegalArgumentException if the dimension is negative
   */
  public DenseLayout {
    if (dimension < 0) {
      throw new IllegalArgumentException(
          "the dimension of a matrix is " + dimension + "; it must not be negative");
    }
  }

  @Override
  public int length() {
    return dimension * dimension;
  }

  @Override
  public int firstRow(int column) {
    return 0;
  }

  @Override
  public int lastRow(int column) {
    return dimension - 1;
  }

  @Override
  public int index(int row, int column) {
    return row * dimension + column;
  }

  @Override
  public int columnDistance() {
    return Math.max(1, dimension);
  }

  @Override
  public void addProduct(double[] matrix, double[] x, double[] sum) {
    int i = 0;
    for (; i < dimension - 3; i += 4) {
      addFourProducts(matrix, x, sum, i);
    }
    for (; i < dimension; i++) {
      double element = sum[i];
      for (int j = 0; j < dimension; j++) {
        element += matrix[i * dimension + j] * x[j];
      }
      sum[i] = element;
    }
  }

  /** Rows i to i + 3: none waits for the sums of the others. */
  private void addFourProducts(double[] matrix, double[] x, double[] sum, int i) {
    int row1 = i * dimension;
    int row2 = row1 + dimension;
    int row3 = row2 + dimension;
    int row4 = row3 + dimension;
    double sum1 = sum[i];
    double sum2 = sum[i + 1];
    double sum3 = sum[i + 2];
    double sum4 = sum[i + 3];
    for (int j = 0; j < dimension; j++) {
      double factor = x[j];
      sum1 += matrix[row1 + j] * factor;
      sum2 += matrix[row2 + j] * factor;
      sum3 += matrix[row3 + j] * factor;
      sum4 += matrix[row4 + j] * factor;
    }
    sum[i] = sum1;
    sum[i + 1] = sum2;
    sum[i + 2] = sum3;
    sum[i + 3] = sum4;
  }
}
