package org.mechservice.solver.linear;

import java.util.Arrays;

/**
 * A matrix of which only the elements of a fixed pattern differ from zero, held row by row, the
 * columns of a row ascending. Patterns are shared and must not be written to; values may be.
 */
public final class SparseMatrix {
  /** Where each row begins in {@link #column} and {@link #value}; one more than there are rows. */
  public final int[] start;

  /** Column of each element. */
  public final int[] column;

  /** Each element. */
  public final double[] value;

  private final int columns;

  private SparseMatrix(int[] start, int[] column, int columns) {
    this.start = start;
    this.column = column;
    this.columns = columns;
    value = new double[column.length];
  }

  /**
   * Makes a matrix of zeros.
   *
   * @param pattern for each row its columns, ascending, none twice; not modified
   * @param columns number of columns
   * @throws IllegalArgumentException if columns do not ascend or are not below their number
   */
  public static SparseMatrix of(int[][] pattern, int columns) {
    int[] start = new int[pattern.length + 1];
    for (int row = 0; row < pattern.length; row++) {
      start[row + 1] = start[row] + pattern[row].length;
    }
    int[] column = new int[start[pattern.length]];
    for (int row = 0; row < pattern.length; row++) {
      requireAscending(pattern[row], columns);
      System.arraycopy(pattern[row], 0, column, start[row], pattern[row].length);
    }
    return new SparseMatrix(start, column, columns);
  }

  private static void requireAscending(int[] row, int columns) {
    int last = -1;
    for (int j : row) {
      if (j <= last || j >= columns) {
        throw new IllegalArgumentException("column " + j + " of " + columns + " after " + last);
      }
      last = j;
    }
  }

  /** Returns a matrix of zeros of the same pattern. */
  public SparseMatrix sameShape() {
    return new SparseMatrix(start, column, columns);
  }

  /** Returns the number of rows. */
  public int rows() {
    return start.length - 1;
  }

  /** Returns the number of columns. */
  public int columns() {
    return columns;
  }

  /** Takes the elements of a matrix of the same pattern. */
  public void copy(SparseMatrix other) {
    System.arraycopy(other.value, 0, value, 0, value.length);
  }

  /** Sets all elements to zero. */
  public void clear() {
    Arrays.fill(value, 0);
  }

  /**
   * Takes a row's elements from numbers in the order of the columns; those outside the pattern are
   * not looked at.
   *
   * @param dense one number per column from {@code at}; not modified
   */
  public void setRow(int row, double[] dense, int at) {
    for (int e = start[row]; e < start[row + 1]; e++) {
      value[e] = dense[at + column[e]];
    }
  }

  /** Returns the index of an element in {@link #value}, negative if it is not of the pattern. */
  public int elementAt(int row, int j) {
    return Arrays.binarySearch(column, start[row], start[row + 1], j);
  }

  /** Returns an element, zero if it is not of the pattern. */
  public double get(int row, int j) {
    int e = elementAt(row, j);
    return e < 0 ? 0 : value[e];
  }

  /**
   * Writes the first columns, row after row.
   *
   * @param dense rows times {@code stride} numbers; overwritten
   * @param stride how many columns
   */
  public void toDense(double[] dense, int stride) {
    Arrays.fill(dense, 0, rows() * stride, 0);
    for (int row = 0; row < rows(); row++) {
      for (int e = start[row]; e < start[row + 1] && column[e] < stride; e++) {
        dense[row * stride + column[e]] = value[e];
      }
    }
  }

  /** Returns a row times the numbers of a vector that begin at {@code at}. */
  public double product(int row, double[] x, int at) {
    double sum = 0;
    for (int e = start[row]; e < start[row + 1]; e++) {
      sum += value[e] * x[at + column[e]];
    }
    return sum;
  }

  /** Adds a row times a factor to the numbers of a vector that begin at {@code at}. */
  public void addRow(int row, double factor, double[] x, int at) {
    for (int e = start[row]; e < start[row + 1]; e++) {
      x[at + column[e]] += factor * value[e];
    }
  }
}
