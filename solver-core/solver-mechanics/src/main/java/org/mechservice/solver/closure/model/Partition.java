package org.mechservice.solver.closure.model;

import java.util.Arrays;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * Partition of m equations in n unknowns, of rank r: r kept equations determine r dependent
 * unknowns from the n − r independent ones. A_kept,dependent is the block that is factored.
 * Workspace of one thread.
 *
 * <p>Matrices have m rows, all with one pattern; only their first n columns are used.
 */
public abstract class Partition {
  final int m;
  final int n;
  final int rank;

  /** Kept equations and dependent unknowns, r of each; independent unknowns, n − r. */
  public final int[] kept;

  public final int[] dependent;
  public final int[] independent;
  private final boolean[] isIndependent;

  private final double[] ofDependent;

  /** Factors of rows and columns for the comparison of pivots. */
  final double[] rowScale;

  final double[] columnScale;

  Partition(int equations, int unknowns, int rank) {
    m = equations;
    n = unknowns;
    this.rank = rank;
    kept = new int[rank];
    dependent = new int[rank];
    independent = new int[n - rank];
    isIndependent = new boolean[n];
    ofDependent = new double[rank];
    rowScale = new double[m];
    columnScale = new double[n];
  }

  /**
   * Returns a partition without a choice yet: by full pivoting for small systems, by sparse
   * elimination for large ones.
   *
   * @param pattern of the matrices, m rows
   * @param unknowns n
   * @param rank r, the number of independent equations
   * @param large whether the system is large
   */
  static Partition of(SparseMatrix pattern, int unknowns, int rank, boolean large) {
    return large
        ? new SparsePartition(pattern, unknowns, rank)
        : new DensePartition(pattern.rows(), unknowns, rank);
  }

  /** Copies the choice and the scales of a partition of the same size. */
  void copyChoice(Partition other) {
    scale(other.rowScale, other.columnScale);
    System.arraycopy(other.kept, 0, kept, 0, rank);
    System.arraycopy(other.dependent, 0, dependent, 0, rank);
    System.arraycopy(other.independent, 0, independent, 0, n - rank);
    System.arraycopy(other.isIndependent, 0, isIndependent, 0, n);
  }

  /** Returns r. */
  public final int rank() {
    return rank;
  }

  /** Returns n − r, the number of independent unknowns. */
  public final int freedom() {
    return n - rank;
  }

  final boolean isIndependent(int unknown) {
    return isIndependent[unknown];
  }

  /**
   * Sets the scales of equations and unknowns for all later choices and pivots.
   *
   * @param rows factor per equation
   * @param columns factor per unknown
   */
  final void scale(double[] rows, double[] columns) {
    System.arraycopy(rows, 0, rowScale, 0, m);
    System.arraycopy(columns, 0, columnScale, 0, n);
  }

  /**
   * Chooses kept equations and dependent unknowns by the largest pivots.
   *
   * @param a not modified
   * @return whether there are r pivots
   */
  abstract boolean choose(SparseMatrix a);

  /** Sets the kept equations and the dependent unknowns, r of each. */
  final void take(int[] equations, int[] unknowns) {
    Arrays.fill(isIndependent, true);
    System.arraycopy(equations, 0, kept, 0, rank);
    System.arraycopy(unknowns, 0, dependent, 0, rank);
    for (int unknown : dependent) {
      isIndependent[unknown] = false;
    }
    Arrays.sort(kept);
    Arrays.sort(dependent);
    int next = 0;
    for (int j = 0; j < n; j++) {
      if (isIndependent[j]) {
        independent[next++] = j;
      }
    }
  }

  /**
   * Marks the equations that are not kept.
   *
   * @param leftOut length m; overwritten
   */
  final void listLeftOut(boolean[] leftOut) {
    Arrays.fill(leftOut, true);
    for (int row : kept) {
      leftOut[row] = false;
    }
  }

  /** Returns the length of what {@link #save} writes. */
  int stateLength() {
    return 2 * rank;
  }

  /** Writes the choice. */
  void save(double[] state, int at) {
    for (int k = 0; k < rank; k++) {
      state[at + k] = kept[k];
      state[at + rank + k] = dependent[k];
    }
  }

  /** Restores a choice that {@link #save} wrote. */
  void restore(double[] state, int at) {
    int[] equations = new int[rank];
    int[] unknowns = new int[rank];
    Arrays.setAll(equations, k -> (int) state[at + k]);
    Arrays.setAll(unknowns, k -> (int) state[at + rank + k]);
    take(equations, unknowns);
  }

  /**
   * Makes a new choice if its smallest pivot is larger than a bound; otherwise changes nothing.
   *
   * @return whether the choice has changed
   */
  abstract boolean chooseBetter(SparseMatrix a, double bound);

  /**
   * Examines the matrix of an accepted state, and makes a new choice if its smallest pivot is
   * larger by a factor than that of the present one.
   *
   * @param better factor, at least 1
   * @return whether the choice has changed
   */
  boolean renew(SparseMatrix a, double better) {
    return chooseBetter(a, better * smallestPivot(a));
  }

  /** Returns the length of the argument of {@link #bestPivot(double[])}. */
  abstract int scaledLength();

  /** Returns the scaled elements of the matrix of the last choice; must not be modified. */
  abstract double[] scaled();

  /**
   * Returns the smallest pivot of the best choice in a scaled matrix; 0 if there is none.
   *
   * @param elements in the order of {@link #scaled}; not modified
   */
  abstract double bestPivot(double[] elements);

  /** Returns the smallest pivot of the best choice in the last matrix examined. */
  abstract double bestPivot();

  /** Returns the equation with the smallest pivot in the last matrix examined. */
  abstract int weakestRow();

  /** Returns the smallest pivot of the dependent block in scaled units; 0 if it is singular. */
  abstract double smallestPivot(SparseMatrix a);

  /** Factors the dependent block; returns whether it is regular. */
  abstract boolean factor(SparseMatrix a);

  /**
   * Returns the sign of the determinant of the block last factored, which is regular. It may be
   * compared between matrices as long as the choice is the same.
   */
  abstract int orientation();

  /** Solves A_kept,dependent x = b in place. */
  abstract void solve(double[] b);

  /** Solves A_kept,dependentᵀ x = b in place. */
  abstract void solveTransposed(double[] b);

  /**
   * Writes the multipliers of the kept equations, f + Aᵀ λ = 0, from the dependent unknowns; those
   * of other equations are zero. The dependent block has been factored.
   *
   * @param f n numbers, such as M a + b − τ; not modified
   * @param lambda one number per equation; overwritten
   */
  final void multipliers(double[] f, double[] lambda) {
    for (int k = 0; k < rank; k++) {
      ofDependent[k] = -f[dependent[k]];
    }
    solveTransposed(ofDependent);
    Arrays.fill(lambda, 0);
    for (int k = 0; k < rank; k++) {
      lambda[kept[k]] = ofDependent[k];
    }
  }

  /**
   * Completes unknowns so that the kept equations A x + c = 0 hold. The dependent block has been
   * factored.
   *
   * @param c one number per equation; not modified
   * @param x n numbers; the dependent ones are overwritten
   */
  final void complete(SparseMatrix a, double[] c, double[] x) {
    for (int k = 0; k < rank; k++) {
      int row = kept[k];
      double sum = c[row];
      for (int e = a.start[row]; e < a.start[row + 1]; e++) {
        int j = a.column[e];
        if (j < n && isIndependent[j]) {
          sum += a.value[e] * x[j];
        }
      }
      ofDependent[k] = -sum;
    }
    solve(ofDependent);
    for (int k = 0; k < rank; k++) {
      x[dependent[k]] = ofDependent[k];
    }
  }

  /**
   * Writes (f + Aᵀ λ) of the independent unknowns, which is Rᵀ f for the multipliers of f.
   *
   * @param f n numbers; overwritten with f + Aᵀ λ
   * @param lambda what {@link #multipliers} wrote for f; not modified
   * @param projected one number per independent unknown; overwritten
   */
  final void project(SparseMatrix a, double[] f, double[] lambda, double[] projected) {
    for (int row : kept) {
      for (int e = a.start[row]; e < a.start[row + 1]; e++) {
        if (a.column[e] < n) {
          f[a.column[e]] += a.value[e] * lambda[row];
        }
      }
    }
    for (int j = 0; j < independent.length; j++) {
      projected[j] = f[independent[j]];
    }
  }
}
