package org.mechservice.solver.dynamics.tree;

import java.util.Optional;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;

/**
 * Factors of a {@link TreeSquare}, eliminated along the tree from the leaves to the root without
 * interchanges, so that no fill-in occurs outside the pattern. If elements grow too much or a pivot
 * vanishes, the matrix is factored again as a dense one with interchanges, and a counter records it
 * (docs/theory/formulations.md#rr-jf-the-jacobian-by-recursion). Workspace of one thread.
 */
public final class TreeLu {
  /**
   * Largest permitted ratio of a subtracted element to its row: the solution then loses at most
   * three digits beyond its condition.
   */
  private static final double GROWTH_ALLOWED = 1e3;

  /** All places regular, as {@link LinearSolver#NONSINGULAR}. */
  public static final int NONSINGULAR = LinearSolver.NONSINGULAR;

  private final TreePattern pattern;
  private final TreeSquare factors;

  /** Dense factorisation, created on first use. */
  private Optional<DenseLu> dense = Optional.empty();

  private double[] full = {};

  /** Largest element of each row before elimination. */
  private final double[] rowSize;

  private final double[] work;

  /**
   * The lower factor by columns: start of each column and end of the last, then for each element
   * its row, its index in the row layout, and its value.
   */
  private final int[] columnStart;

  private final int[] row;
  private final int[] elementByRows;
  private final double[] lowerByColumns;

  private boolean onTree;
  private long denseFactorizations;

  /** Makes a workspace for matrices of a pattern. */
  public TreeLu(TreePattern pattern) {
    this.pattern = pattern;
    int n = pattern.size;
    factors = new TreeSquare(pattern);
    rowSize = new double[n];
    work = new double[n];
    columnStart = new int[n + 1];
    row = new int[pattern.column.length];
    elementByRows = new int[pattern.column.length];
    lowerByColumns = new double[pattern.column.length];
    orderByColumns();
  }

  private void orderByColumns() {
    for (int k : pattern.column) {
      columnStart[k + 1]++;
    }
    for (int k = 0; k < pattern.size; k++) {
      columnStart[k + 1] += columnStart[k];
    }
    int[] next = columnStart.clone();
    for (int i = 0; i < pattern.size; i++) {
      for (int e = pattern.rowStart[i]; e < pattern.rowStart[i + 1]; e++) {
        int at = next[pattern.column[e]]++;
        row[at] = i;
        elementByRows[at] = e;
      }
    }
  }

  /** Returns how often a matrix had to be factored as a dense one. */
  public long denseFactorizations() {
    return denseFactorizations;
  }

  /**
   * Factors a matrix.
   *
   * @param matrix of the same pattern; not modified
   * @return {@link #NONSINGULAR}, or the velocity in whose column no pivot is left
   */
  public int factor(TreeSquare matrix) {
    System.arraycopy(matrix.diagonal, 0, factors.diagonal, 0, pattern.size);
    System.arraycopy(matrix.lower, 0, factors.lower, 0, factors.lower.length);
    System.arraycopy(matrix.upper, 0, factors.upper, 0, factors.upper.length);
    formRowSizes(matrix);
    onTree = eliminateOnTree();
    if (onTree) {
      double[] lower = factors.lower;
      for (int f = 0; f < lowerByColumns.length; f++) {
        lowerByColumns[f] = lower[elementByRows[f]];
      }
      return NONSINGULAR;
    }
    denseFactorizations++;
    if (dense.isEmpty()) {
      dense = Optional.of(new DenseLu(pattern.size));
      full = new double[pattern.size * pattern.size];
    }
    matrix.toDense(full);
    return dense.get().factor(full);
  }

  private void formRowSizes(TreeSquare matrix) {
    double[] sizes = rowSize;
    int[] column = pattern.column;
    for (int k = 0; k < sizes.length; k++) {
      sizes[k] = Math.abs(matrix.diagonal[k]);
    }
    int e = 0;
    for (int k = 0; k < sizes.length; k++) {
      double size = sizes[k];
      for (int end = pattern.rowStart[k + 1]; e < end; e++) {
        size = larger(size, Math.abs(matrix.lower[e]));
        int i = column[e];
        sizes[i] = larger(sizes[i], Math.abs(matrix.upper[e]));
      }
      sizes[k] = size;
    }
  }

  /** Returns the larger of two sizes, or NaN if one of them is NaN. */
  private static double larger(double a, double b) {
    return a >= b || Double.isNaN(a) ? a : b;
  }

  private boolean eliminateOnTree() {
    for (int k = pattern.size - 1; k >= 0; k--) {
      double pivot = Math.abs(factors.diagonal[k]);
      if (!(pivot >= Double.MIN_NORMAL && pivot < Double.POSITIVE_INFINITY)) {
        return false;
      }
      if (!eliminate(k, 1 / factors.diagonal[k])) {
        return false;
      }
    }
    return true;
  }

  /**
   * A_ij −= A_ik A_kj / A_kk for all i, j coupled with k; then A_ik /= A_kk.
   *
   * @return whether what is subtracted from each row is small enough beside the row
   */
  private boolean eliminate(int k, double perPivot) {
    double[] lower = factors.lower;
    double[] upper = factors.upper;
    int start = pattern.rowStart[k];
    double largest = largestOfRow(k);
    for (int e = pattern.rowStart[k + 1] - 1; e >= start; e--) {
      int i = pattern.column[e];
      double l = upper[e] * perPivot;
      if (!(Math.abs(l) * largest <= GROWTH_ALLOWED * rowSize[i])) {
        return false;
      }
      factors.diagonal[i] -= l * lower[e];
      if (pattern.bareTree) {
        subtractPrefix(start, e, pattern.rowStart[i] - start, l, lower[e] * perPivot);
      } else {
        subtractScattered(start, e, pattern.rowStart[i], l, lower[e] * perPivot);
      }
      upper[e] = l;
    }
    return true;
  }

  private double largestOfRow(int k) {
    double[] lower = factors.lower;
    double largest = Math.abs(factors.diagonal[k]);
    for (int e = pattern.rowStart[k]; e < pattern.rowStart[k + 1]; e++) {
      largest = larger(largest, Math.abs(lower[e]));
    }
    return largest;
  }

  private void subtractPrefix(int from, int to, int shift, double l, double u) {
    double[] lower = factors.lower;
    double[] upper = factors.upper;
    for (int f = from; f < to; f++) {
      lower[f + shift] -= l * lower[f];
      upper[f + shift] -= upper[f] * u;
    }
  }

  private void subtractScattered(int from, int to, int target, double l, double u) {
    double[] lower = factors.lower;
    double[] upper = factors.upper;
    int[] column = pattern.column;
    int t = target;
    for (int f = from; f < to; f++) {
      while (column[t] != column[f]) {
        t++;
      }
      lower[t] -= l * lower[f];
      upper[t] -= upper[f] * u;
    }
  }

  /**
   * Solves A x = b with the last factors. Both triangles are traversed by columns, which avoids
   * long dependent sums.
   *
   * @param b right-hand side in the order of the state, length n; overwritten with x
   */
  public void solve(double[] b) {
    if (!onTree) {
      dense.orElseThrow(() -> new IllegalStateException("no matrix has been factored")).solve(b);
      return;
    }
    double[] x = work;
    int[] velocityAt = pattern.velocityAt;
    for (int k = 0; k < x.length; k++) {
      x[k] = b[velocityAt[k]];
    }
    substituteInwards(x);
    double[] diagonal = factors.diagonal;
    int f = 0;
    for (int k = 0; k < x.length; k++) {
      double value = x[k] / diagonal[k];
      b[velocityAt[k]] = value;
      for (int end = columnStart[k + 1]; f < end; f++) {
        x[row[f]] -= lowerByColumns[f] * value;
      }
    }
  }

  private void substituteInwards(double[] x) {
    double[] upper = factors.upper;
    int[] column = pattern.column;
    int e = upper.length - 1;
    for (int k = x.length - 1; k > 0; k--) {
      double value = x[k];
      for (int start = pattern.rowStart[k]; e >= start; e--) {
        x[column[e]] -= upper[e] * value;
      }
    }
  }
}
