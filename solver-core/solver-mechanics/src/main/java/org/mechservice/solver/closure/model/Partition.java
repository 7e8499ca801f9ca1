package org.mechservice.solver.closure.model;

import java.util.Arrays;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.PivotedElimination;

/**
 * Which unknowns of m equations in n unknowns, r of them independent, are found from the others,
 * and by which r equations: A_kept,dependent is the block that is solved with. Workspace of one
 * thread; nothing allocates after construction.
 */
public final class Partition {
  private final int m;
  private final int n;
  private final int rank;
  private final PivotedElimination elimination;
  private final PivotedElimination block;
  private final DenseLu factors;

  /** Kept equations and dependent unknowns, r of each; independent unknowns, n − r. */
  public final int[] kept;

  public final int[] dependent;
  public final int[] independent;
  private final boolean[] isIndependent;

  /** What rows and columns are multiplied by before pivots are compared. */
  private final double[] rowScale;

  private final double[] columnScale;
  private final double[] scaled;
  private final double[] blockElements;

  /** Number of pivots in the matrix last looked at. */
  private int found;

  /**
   * @param equations m
   * @param unknowns n
   * @param rank r, the number of independent equations
   */
  Partition(int equations, int unknowns, int rank) {
    m = equations;
    n = unknowns;
    this.rank = rank;
    elimination = new PivotedElimination(m, n);
    block = new PivotedElimination(rank, rank);
    factors = new DenseLu(rank);
    kept = new int[rank];
    dependent = new int[rank];
    independent = new int[n - rank];
    isIndependent = new boolean[n];
    rowScale = new double[m];
    columnScale = new double[n];
    scaled = new double[m * n];
    blockElements = new double[rank * rank];
  }

  /** Takes over the choice of another of the same size. */
  void copyChoice(Partition other) {
    System.arraycopy(other.kept, 0, kept, 0, rank);
    System.arraycopy(other.dependent, 0, dependent, 0, rank);
    System.arraycopy(other.independent, 0, independent, 0, n - rank);
    System.arraycopy(other.isIndependent, 0, isIndependent, 0, n);
  }

  /** Returns r. */
  public int rank() {
    return rank;
  }

  /** Returns the number of unknowns that are not found from others. */
  public int freedom() {
    return n - rank;
  }

  boolean isIndependent(int unknown) {
    return isIndependent[unknown];
  }

  /**
   * Sets what makes equations and unknowns comparable, for choices and pivots from now on.
   *
   * @param rows factor per equation; 0 for one that must not be kept
   * @param columns factor per unknown
   */
  void scale(double[] rows, double[] columns) {
    System.arraycopy(rows, 0, rowScale, 0, m);
    System.arraycopy(columns, 0, columnScale, 0, n);
  }

  /**
   * Chooses kept equations and dependent unknowns by the largest pivots.
   *
   * @param a m rows of {@code stride} numbers, of which the first n count; not modified
   * @return whether there are r pivots
   */
  boolean choose(double[] a, int stride) {
    formScaled(a, stride);
    if (bestPivot(scaled) == 0) {
      return false;
    }
    takeChoice();
    return true;
  }

  private void formScaled(double[] a, int stride) {
    for (int i = 0; i < m; i++) {
      for (int j = 0; j < n; j++) {
        scaled[i * n + j] = rowScale[i] * a[i * stride + j] * columnScale[j];
      }
    }
  }

  private void takeChoice() {
    Arrays.fill(isIndependent, true);
    for (int k = 0; k < rank; k++) {
      kept[k] = elimination.row(k);
      dependent[k] = elimination.column(k);
      isIndependent[dependent[k]] = false;
    }
    Arrays.sort(kept);
    Arrays.sort(dependent);
    listIndependent();
  }

  private void listIndependent() {
    int next = 0;
    for (int j = 0; j < n; j++) {
      if (isIndependent[j]) {
        independent[next++] = j;
      }
    }
  }

  /**
   * Tells which equations are left out.
   *
   * @param leftOut length m; overwritten
   */
  void listLeftOut(boolean[] leftOut) {
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

  /** Takes up a choice that {@link #save} wrote. */
  void restore(double[] state, int at) {
    Arrays.fill(isIndependent, true);
    for (int k = 0; k < rank; k++) {
      kept[k] = (int) state[at + k];
      dependent[k] = (int) state[at + rank + k];
      isIndependent[dependent[k]] = false;
    }
    listIndependent();
  }

  /**
   * Chooses anew if that gives a smallest pivot larger than a bound; otherwise everything stays.
   *
   * @return whether the choice is another
   */
  boolean chooseBetter(double[] a, int stride, double bound) {
    formScaled(a, stride);
    if (!(bestPivot(scaled) > bound)) {
      return false;
    }
    takeChoice();
    return true;
  }

  /** Returns the matrix that was last chosen from, in scaled units. */
  double[] scaled() {
    return scaled;
  }

  /**
   * Returns the smallest pivot of the best choice in a matrix of scaled units; 0 if it has none.
   */
  double bestPivot(double[] matrix) {
    found = elimination.eliminate(matrix, rank);
    return bestPivot();
  }

  /** Returns the same of the matrix that was last chosen from or looked at. */
  double bestPivot() {
    return rank == 0 ? 1 : found < rank ? 0 : elimination.pivot(rank - 1);
  }

  /** Returns the equation that had the smallest pivot when a matrix was last looked at. */
  int weakestRow() {
    return rank == 0 ? 0 : elimination.row(rank - 1);
  }

  /** Returns the smallest pivot of the dependent block in scaled units; 0 if it is singular. */
  double smallestPivot(double[] a, int stride) {
    for (int i = 0; i < rank; i++) {
      for (int j = 0; j < rank; j++) {
        blockElements[i * rank + j] =
            rowScale[kept[i]] * a[kept[i] * stride + dependent[j]] * columnScale[dependent[j]];
      }
    }
    if (rank == 0) {
      return 1;
    }
    return block.eliminate(blockElements, rank) < rank ? 0 : block.pivot(rank - 1);
  }

  /** Factors the dependent block; returns whether it is regular. */
  boolean factor(double[] a, int stride) {
    for (int i = 0; i < rank; i++) {
      for (int j = 0; j < rank; j++) {
        blockElements[i * rank + j] = a[kept[i] * stride + dependent[j]];
      }
    }
    return factors.factor(blockElements) == LinearSolver.NONSINGULAR;
  }

  /** Solves A_kept,dependent x = b in place. */
  void solve(double[] b) {
    factors.solve(b);
  }

  /** Solves A_kept,dependentᵀ x = b in place. */
  void solveTransposed(double[] b) {
    factors.solveTransposed(b);
  }
}
