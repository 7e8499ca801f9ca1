package org.mechservice.solver.linear;

/** Which elements of a square matrix may differ from zero and where in a flat array they are. */
public interface MatrixLayout {
  /** Returns n, the number of rows and of columns. */
  int dimension();

  /** Returns the length of the array. */
  int length();

  /** Returns the first row of a column that may differ from zero. */
  int firstRow(int column);

  /** Returns the last row of a column that may differ from zero. */
  int lastRow(int column);

  /**
   * Returns the row of a column that may differ from zero next; more than the last one behind that.
   *
   * @param row one that may differ from zero
   */
  default int nextRow(int row, int column) {
    return row + 1;
  }

  /**
   * Returns the place of an element in the array.
   *
   * @param row one that may differ from zero in the column
   * @param column from 0 to n − 1
   */
  int index(int row, int column);

  /**
   * Returns the smallest distance d ≥ 1 such that the columns j, j + d, j + 2d, … have no row in
   * common, for every j; n if there is none.
   */
  int columnDistance();

  /**
   * Adds A x to a vector.
   *
   * @param matrix elements of A, length {@link #length}
   * @param x length n
   * @param sum length n; added to, each of its elements in the order of the columns
   */
  default void addProduct(double[] matrix, double[] x, double[] sum) {
    for (int j = 0; j < x.length; j++) {
      for (int i = firstRow(j); i <= lastRow(j); i = nextRow(i, j)) {
        sum[i] += matrix[index(i, j)] * x[j];
      }
    }
  }
}
