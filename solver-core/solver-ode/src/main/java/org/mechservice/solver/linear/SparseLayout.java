package org.mechservice.solver.linear;

import java.util.Arrays;

/**
 * The elements of a pattern, column after column, and the whole diagonal. Places of elements are
 * found by bisection in their column.
 */
public final class SparseLayout implements MatrixLayout {
  private final int dimension;

  /** Place of the first element of each column; length n + 1. */
  private final int[] start;

  /** Row of each element, ascending in each column. */
  private final int[] row;

  private SparseLayout(int dimension, int[] start, int[] row) {
    this.dimension = dimension;
    this.start = start;
    this.row = row;
  }

  /**
   * Returns the layout of a pattern.
   *
   * @param rows for each column the rows, ascending, whose elements may differ from zero; not
   *     modified
   */
  public static SparseLayout of(int[][] rows) {
    int n = rows.length;
    int[] start = new int[n + 1];
    for (int j = 0; j < n; j++) {
      boolean diagonal = Arrays.binarySearch(rows[j], j) >= 0;
      start[j + 1] = Math.addExact(start[j], rows[j].length + (diagonal ? 0 : 1));
    }
    int[] row = new int[start[n]];
    for (int j = 0; j < n; j++) {
      System.arraycopy(rows[j], 0, row, start[j], rows[j].length);
      if (start[j] + rows[j].length < start[j + 1]) {
        row[start[j + 1] - 1] = j;
        Arrays.sort(row, start[j], start[j + 1]);
      }
    }
    return new SparseLayout(n, start, row);
  }

  @Override
  public int dimension() {
    return dimension;
  }

  @Override
  public int length() {
    return row.length;
  }

  /** Returns the place of the first element of a column, for column n that behind the last. */
  int start(int column) {
    return start[column];
  }

  /** Returns the row of the element at a place. */
  int rowAt(int place) {
    return row[place];
  }

  @Override
  public int firstRow(int column) {
    return row[start[column]];
  }

  @Override
  public int lastRow(int column) {
    return row[start[column + 1] - 1];
  }

  @Override
  public int nextRow(int row, int column) {
    int next = index(row, column) + 1;
    return next < start[column + 1] ? this.row[next] : row + 1;
  }

  /**
   * {@inheritDoc}
   *
   * @return negative for an element that the pattern has not
   */
  @Override
  public int index(int row, int column) {
    return Arrays.binarySearch(this.row, start[column], start[column + 1], row);
  }

  /** {@inheritDoc} Which columns have no row in common is not a matter of distance here. */
  @Override
  public int columnDistance() {
    return Math.max(1, dimension);
  }

  @Override
  public void addProduct(double[] matrix, double[] x, double[] sum) {
    for (int j = 0; j < dimension; j++) {
      for (int place = start[j]; place < start[j + 1]; place++) {
        sum[row[place]] += matrix[place] * x[j];
      }
    }
  }
}
