package org.mechservice.solver.dynamics.tree;

import java.util.Arrays;

/**
 * An unsymmetric matrix over the velocities of the state, with the elements of a {@link
 * TreePattern} on both sides of the diagonal. Elements are addressed by place. Workspace of one
 * thread.
 */
public final class TreeSquare implements TreeElements {
  public final TreePattern pattern;
  public final double[] diagonal;

  /** Element (row, column) for each column of a row in the pattern. */
  public final double[] lower;

  /** Element (column, row) for each column of a row in the pattern. */
  public final double[] upper;

  /** A vector and its product with the matrix, by place. */
  private final double[] placed;

  private final double[] product;

  /** Makes a matrix of zeros. */
  public TreeSquare(TreePattern pattern) {
    this.pattern = pattern;
    diagonal = new double[pattern.size];
    lower = new double[pattern.column.length];
    upper = new double[pattern.column.length];
    placed = new double[pattern.size];
    product = new double[pattern.size];
  }

  @Override
  public double[] diagonal() {
    return diagonal;
  }

  @Override
  public double[] lower() {
    return lower;
  }

  @Override
  public double[] upper() {
    return upper;
  }

  /** Sets all elements to zero. */
  public void clear() {
    Arrays.fill(diagonal, 0);
    Arrays.fill(lower, 0);
    Arrays.fill(upper, 0);
  }

  /** Takes the elements of a matrix of the same pattern. */
  public void copy(TreeSquare other) {
    System.arraycopy(other.diagonal, 0, diagonal, 0, diagonal.length);
    System.arraycopy(other.lower, 0, lower, 0, lower.length);
    System.arraycopy(other.upper, 0, upper, 0, upper.length);
  }

  /**
   * Adds to an element.
   *
   * @param row velocity of the state
   * @param column velocity of the state, coupled with the row
   */
  public void add(int row, int column, double value) {
    int r = pattern.placeOf[row];
    int c = pattern.placeOf[column];
    if (r == c) {
      diagonal[r] += value;
    } else if (r > c) {
      lower[pattern.find(r, c)] += value;
    } else {
      upper[pattern.find(c, r)] += value;
    }
  }

  /**
   * Returns an element.
   *
   * @param row velocity of the state
   * @param column velocity of the state
   */
  public double get(int row, int column) {
    int r = pattern.placeOf[row];
    int c = pattern.placeOf[column];
    if (r == c) {
      return diagonal[r];
    }
    int index = pattern.find(Math.max(r, c), Math.min(r, c));
    if (index < 0) {
      return 0;
    }
    return r > c ? lower[index] : upper[index];
  }

  /**
   * Writes the elements, row by row in the order of the state.
   *
   * @param dense n² numbers; overwritten
   */
  public void toDense(double[] dense) {
    int n = pattern.size;
    Arrays.fill(dense, 0, n * n, 0);
    for (int row = 0; row < n; row++) {
      int i = pattern.velocityAt[row];
      dense[n * i + i] = diagonal[row];
      for (int e = pattern.rowStart[row]; e < pattern.rowStart[row + 1]; e++) {
        int j = pattern.velocityAt[pattern.column[e]];
        dense[n * i + j] = lower[e];
        dense[n * j + i] = upper[e];
      }
    }
  }

  /**
   * Adds the elements to a matrix, row by row in the order of the state.
   *
   * @param dense n² numbers from {@code at}; added to
   */
  public void addTo(double[] dense, int at) {
    int n = pattern.size;
    for (int row = 0; row < n; row++) {
      int i = pattern.velocityAt[row];
      dense[at + n * i + i] += diagonal[row];
      for (int e = pattern.rowStart[row]; e < pattern.rowStart[row + 1]; e++) {
        int j = pattern.velocityAt[pattern.column[e]];
        dense[at + n * i + j] += lower[e];
        dense[at + n * j + i] += upper[e];
      }
    }
  }

  /**
   * Copies the elements from a matrix, row by row in the order of the state.
   *
   * @param dense n² numbers from {@code at}; not modified
   */
  public void take(double[] dense, int at) {
    int n = pattern.size;
    for (int row = 0; row < n; row++) {
      int i = pattern.velocityAt[row];
      diagonal[row] = dense[at + n * i + i];
      for (int e = pattern.rowStart[row]; e < pattern.rowStart[row + 1]; e++) {
        int j = pattern.velocityAt[pattern.column[e]];
        lower[e] = dense[at + n * i + j];
        upper[e] = dense[at + n * j + i];
      }
    }
  }

  /**
   * Adds factor · A x to y.
   *
   * @param x in the order of the state from {@code xAt}; not modified
   * @param y in the order of the state from {@code yAt}; added to
   */
  public void addProduct(double factor, double[] x, int xAt, double[] y, int yAt) {
    int[] velocityAt = pattern.velocityAt;
    int[] column = pattern.column;
    double[] in = placed;
    double[] out = product;
    for (int place = 0; place < in.length; place++) {
      in[place] = factor * x[xAt + velocityAt[place]];
    }
    int e = 0;
    for (int row = 0; row < in.length; row++) {
      double own = in[row];
      double sum = diagonal[row] * own;
      for (int end = pattern.rowStart[row + 1]; e < end; e++) {
        int place = column[e];
        sum += lower[e] * in[place];
        out[place] += upper[e] * own;
      }
      out[row] = sum;
    }
    for (int place = 0; place < out.length; place++) {
      y[yAt + velocityAt[place]] += out[place];
    }
  }

  /** Returns whether all elements are finite. */
  public boolean isFinite() {
    double sum = 0;
    for (double x : diagonal) {
      sum += 0 * x;
    }
    for (int e = 0; e < lower.length; e++) {
      sum += 0 * lower[e] + 0 * upper[e];
    }
    return sum == 0;
  }
}
