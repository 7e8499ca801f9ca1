package org.mechservice.solver.dynamics;

import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;

/**
 * Factors of a {@link TreeSquare}, eliminated along the tree from the leaves to the root without
 * interchanges, so that none but the elements of the pattern are filled. Whether that was safe is
 * watched: if elements grow too much or a pivot vanishes, the matrix is factored again as a dense
 * one with interchanges, and that is counted (NUMERICS §2). Workspace of one thread.
 */
public final class TreeLu {
  /**
   * How much larger than its row may be what is subtracted from it: the solution then loses no more
   * than three digits beyond those its condition takes.
   */
  private static final double GROWTH_ALLOWED = 1e3;

  /** All places regular, as {@link LinearSolver#NONSINGULAR}. */
  public static final int NONSINGULAR = LinearSolver.NONSINGULAR;

  private final TreePattern pattern;
  private final TreeSquare factors;
  private final DenseLu dense;
  private final double[] full;

  /** Largest element of each row before elimination. */
  private final double[] rowSize;

  private final double[] work;
  private boolean onTree;
  private long denseFactorizations;

  /** Makes a workspace for matrices of a pattern. */
  public TreeLu(TreePattern pattern) {
    this.pattern = pattern;
    factors = new TreeSquare(pattern);
    dense = new DenseLu(pattern.size);
    full = new double[pattern.size * pattern.size];
    rowSize = new double[pattern.size];
    work = new double[pattern.size];
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
      return NONSINGULAR;
    }
    denseFactorizations++;
    matrix.toDense(full);
    return dense.factor(full);
  }

  private void formRowSizes(TreeSquare matrix) {
    for (int k = 0; k < pattern.size; k++) {
      rowSize[k] = Math.abs(matrix.diagonal[k]);
    }
    for (int k = 0; k < pattern.size; k++) {
      for (int e = pattern.rowStart[k]; e < pattern.rowStart[k + 1]; e++) {
        int i = pattern.column[e];
        rowSize[k] = Math.max(rowSize[k], Math.abs(matrix.lower[e]));
        rowSize[i] = Math.max(rowSize[i], Math.abs(matrix.upper[e]));
      }
    }
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
    }
    for (int e = start; e < pattern.rowStart[k + 1]; e++) {
      upper[e] *= perPivot;
    }
    return true;
  }

  private double largestOfRow(int k) {
    double largest = Math.abs(factors.diagonal[k]);
    for (int e = pattern.rowStart[k]; e < pattern.rowStart[k + 1]; e++) {
      largest = Math.max(largest, Math.abs(factors.lower[e]));
    }
    return largest;
  }

  private void subtractPrefix(int from, int to, int shift, double l, double u) {
    for (int f = from; f < to; f++) {
      factors.lower[f + shift] -= l * factors.lower[f];
      factors.upper[f + shift] -= factors.upper[f] * u;
    }
  }

  private void subtractScattered(int from, int to, int target, double l, double u) {
    int t = target;
    for (int f = from; f < to; f++) {
      while (pattern.column[t] != pattern.column[f]) {
        t++;
      }
      factors.lower[t] -= l * factors.lower[f];
      factors.upper[t] -= factors.upper[f] * u;
    }
  }

  /**
   * Solves A x = b with the last factors.
   *
   * @param b right-hand side in the order of the state, length n; overwritten with x
   */
  public void solve(double[] b) {
    if (!onTree) {
      dense.solve(b);
      return;
    }
    int n = pattern.size;
    for (int k = 0; k < n; k++) {
      work[k] = b[pattern.velocityAt[k]];
    }
    for (int k = n - 1; k >= 0; k--) {
      for (int e = pattern.rowStart[k]; e < pattern.rowStart[k + 1]; e++) {
        work[pattern.column[e]] -= factors.upper[e] * work[k];
      }
    }
    for (int k = 0; k < n; k++) {
      double sum = work[k];
      for (int e = pattern.rowStart[k]; e < pattern.rowStart[k + 1]; e++) {
        sum -= factors.lower[e] * work[pattern.column[e]];
      }
      work[k] = sum / factors.diagonal[k];
      b[pattern.velocityAt[k]] = work[k];
    }
  }
}
