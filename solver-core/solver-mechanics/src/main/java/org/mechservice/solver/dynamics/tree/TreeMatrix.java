package org.mechservice.solver.dynamics.tree;

import java.util.Arrays;
import org.mechservice.solver.api.capability.ExplicitModel;

/**
 * A symmetric matrix over the velocities of the state with the elements of a {@link TreePattern},
 * and its factors LᵀDL with L unit lower triangular. Workspace of one thread.
 *
 * <p>Elements are addressed by place; vectors are in the order of the state.
 */
public final class TreeMatrix implements TreeElements {
  private final TreePattern pattern;
  private final double[] diagonal;
  private final double[] lower;
  private final double[] work;
  private boolean factored;

  /** Makes a matrix of zeros. */
  public TreeMatrix(TreePattern pattern) {
    this.pattern = pattern;
    diagonal = new double[pattern.size];
    lower = new double[pattern.column.length];
    work = new double[pattern.size];
  }

  /** Sets all elements to zero. */
  public void clear() {
    Arrays.fill(diagonal, 0);
    Arrays.fill(lower, 0);
    factored = false;
  }

  public void setDiagonal(int place, double value) {
    diagonal[place] = value;
  }

  /** Sets an element below the diagonal by its index in the pattern's columns. */
  public void setElement(int index, double value) {
    lower[index] = value;
  }

  /**
   * Adds to an element and its mirror image.
   *
   * @param velocity1 velocity of the state
   * @param velocity2 velocity of the state, coupled with the first
   */
  public void add(int velocity1, int velocity2, double value) {
    int p1 = pattern.placeOf[velocity1];
    int p2 = pattern.placeOf[velocity2];
    if (p1 == p2) {
      diagonal[p1] += value;
    } else {
      lower[pattern.find(Math.max(p1, p2), Math.min(p1, p2))] += value;
    }
  }

  /** Returns the dimension. */
  public int size() {
    return pattern.size;
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
    return lower;
  }

  /**
   * Returns an element.
   *
   * @param velocity1 velocity of the state
   * @param velocity2 velocity of the state
   */
  public double get(int velocity1, int velocity2) {
    requireElements();
    int p1 = pattern.placeOf[velocity1];
    int p2 = pattern.placeOf[velocity2];
    if (p1 == p2) {
      return diagonal[p1];
    }
    int index = pattern.find(Math.max(p1, p2), Math.min(p1, p2));
    return index < 0 ? 0 : lower[index];
  }

  /** Copies the elements, not the factors, of a matrix of the same pattern. */
  void copy(TreeMatrix other) {
    other.requireElements();
    System.arraycopy(other.diagonal, 0, diagonal, 0, diagonal.length);
    System.arraycopy(other.lower, 0, lower, 0, lower.length);
    factored = false;
  }

  /**
   * Writes the elements, row by row in the order of the state.
   *
   * @param dense n² numbers; overwritten
   * @throws IllegalStateException if the matrix has been factored
   */
  public void toDense(double[] dense) {
    requireElements();
    int n = pattern.size;
    Arrays.fill(dense, 0, n * n, 0);
    for (int row = 0; row < n; row++) {
      int i = pattern.velocityAt[row];
      dense[n * i + i] = diagonal[row];
      for (int e = pattern.rowStart[row]; e < pattern.rowStart[row + 1]; e++) {
        int j = pattern.velocityAt[pattern.column[e]];
        dense[n * i + j] = lower[e];
        dense[n * j + i] = lower[e];
      }
    }
  }

  /**
   * Copies the elements from the lower triangle and the diagonal of a matrix, row by row in the
   * order of the state.
   *
   * @param dense n² numbers from {@code at}; not modified
   */
  public void take(double[] dense, int at) {
    int n = pattern.size;
    factored = false;
    for (int row = 0; row < n; row++) {
      int i = pattern.velocityAt[row];
      diagonal[row] = dense[at + n * i + i];
      for (int e = pattern.rowStart[row]; e < pattern.rowStart[row + 1]; e++) {
        int j = pattern.velocityAt[pattern.column[e]];
        lower[e] = dense[at + n * Math.max(i, j) + Math.min(i, j)];
      }
    }
  }

  /**
   * Writes y = M x.
   *
   * @param x not modified
   * @param y from {@code yAt}; overwritten
   * @throws IllegalStateException if the matrix has been factored
   */
  public void multiply(double[] x, int xAt, double[] y, int yAt) {
    requireElements();
    Arrays.fill(y, yAt, yAt + pattern.size, 0);
    for (int row = 0; row < pattern.size; row++) {
      int i = pattern.velocityAt[row];
      double sum = diagonal[row] * x[xAt + i];
      for (int e = pattern.rowStart[row]; e < pattern.rowStart[row + 1]; e++) {
        int j = pattern.velocityAt[pattern.column[e]];
        sum += lower[e] * x[xAt + j];
        y[yAt + j] += lower[e] * x[xAt + i];
      }
      y[yAt + i] += sum;
    }
  }

  private void requireElements() {
    if (factored) {
      throw new IllegalStateException("the matrix has been overwritten by its factors");
    }
  }

  /**
   * Overwrites the matrix by its factors.
   *
   * @param check checks the pivots
   * @param scale reference size of each pivot, one number per velocity of the state
   * @return {@link ExplicitModel#REGULAR}, or the velocity of the first pivot that is zero
   */
  public int factor(PivotCheck check, double[] scale) {
    factored = true;
    check.start();
    for (int k = pattern.size - 1; k >= 0; k--) {
      int velocity = pattern.velocityAt[k];
      if (!check.regular(velocity, diagonal[k], scale[velocity])) {
        return velocity;
      }
      eliminate(k);
    }
    return ExplicitModel.REGULAR;
  }

  /** M_ij −= M_ki M_kj / M_kk for all i, j coupled with k, then M_ki /= M_kk. */
  private void eliminate(int k) {
    int start = pattern.rowStart[k];
    double perPivot = 1 / diagonal[k];
    for (int e = pattern.rowStart[k + 1] - 1; e >= start; e--) {
      int i = pattern.column[e];
      double factor = lower[e] * perPivot;
      diagonal[i] -= factor * lower[e];
      if (pattern.bareTree) {
        subtractPrefix(start, e, pattern.rowStart[i], factor);
      } else {
        subtractScattered(start, e, pattern.rowStart[i], factor);
      }
      lower[e] = factor;
    }
  }

  private void subtractPrefix(int from, int to, int target, double factor) {
    for (int e = from; e < to; e++) {
      lower[target + e - from] -= factor * lower[e];
    }
  }

  private void subtractScattered(int from, int to, int target, double factor) {
    int t = target;
    for (int e = from; e < to; e++) {
      while (pattern.column[t] != pattern.column[e]) {
        t++;
      }
      lower[t] -= factor * lower[e];
    }
  }

  /**
   * Solves M x = b with the factors.
   *
   * @param b right-hand side in the order of the state from {@code at}; overwritten with x
   */
  public void solve(double[] b, int at) {
    int n = pattern.size;
    for (int k = 0; k < n; k++) {
      work[k] = b[at + pattern.velocityAt[k]];
    }
    for (int k = n - 1; k >= 0; k--) {
      for (int e = pattern.rowStart[k]; e < pattern.rowStart[k + 1]; e++) {
        work[pattern.column[e]] -= lower[e] * work[k];
      }
    }
    for (int k = 0; k < n; k++) {
      double sum = work[k] / diagonal[k];
      for (int e = pattern.rowStart[k]; e < pattern.rowStart[k + 1]; e++) {
        sum -= lower[e] * work[pattern.column[e]];
      }
      work[k] = sum;
      b[at + pattern.velocityAt[k]] = sum;
    }
  }

  /**
   * Returns the motion without inertia, after {@link #factor} has found a zero pivot: the velocity
   * found moves by 1, and the velocities beyond it such that M times the motion is zero there.
   *
   * @param velocity result of {@code factor}
   * @return one number per velocity of the state
   */
  public double[] unresistedMotion(int velocity) {
    double[] motion = new double[pattern.size];
    int from = pattern.placeOf[velocity];
    work[from] = 1;
    motion[velocity] = 1;
    for (int k = from + 1; k < pattern.size; k++) {
      double sum = 0;
      for (int e = pattern.rowStart[k]; e < pattern.rowStart[k + 1]; e++) {
        if (pattern.column[e] >= from) {
          sum -= lower[e] * work[pattern.column[e]];
        }
      }
      work[k] = sum;
      motion[pattern.velocityAt[k]] = sum;
    }
    return motion;
  }

  /**
   * Multiplies by a square root of the inverse: x ← D^(−1/2) L⁻ᵀ x, whose squared length is xᵀ M⁻¹
   * x.
   *
   * @param x in the order of the state from {@code at}; overwritten, in the order of elimination
   */
  public void halfSolve(double[] x, int at) {
    int n = pattern.size;
    for (int k = 0; k < n; k++) {
      work[k] = x[at + pattern.velocityAt[k]];
    }
    for (int k = n - 1; k >= 0; k--) {
      for (int e = pattern.rowStart[k]; e < pattern.rowStart[k + 1]; e++) {
        work[pattern.column[e]] -= lower[e] * work[k];
      }
      x[at + k] = work[k] / Math.sqrt(diagonal[k]);
    }
  }
}
