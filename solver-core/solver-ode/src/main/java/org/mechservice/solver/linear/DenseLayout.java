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
    for (; i < dimension - 1; i += 2) {
      addTwoProducts(matrix, x, sum, i);
    }
    if (i < dimension) {
      double element = sum[i];
      for (int j = 0; j < dimension; j++) {
        element += matrix[i * dimension + j] * x[j];
      }
      sum[i] = element;
    }
  }

  /** Rows i and i + 1: neither waits for the sums of the other. */
  private void addTwoProducts(double[] matrix, double[] x, double[] sum, int i) {
    int row = i * dimension;
    int below = row + dimension;
    double first = sum[i];
    double second = sum[i + 1];
    for (int j = 0; j < dimension; j++) {
      first += matrix[row + j] * x[j];
      second += matrix[below + j] * x[j];
    }
    sum[i] = first;
    sum[i + 1] = second;
  }
}
