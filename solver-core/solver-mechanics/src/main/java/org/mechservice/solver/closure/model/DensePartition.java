package org.mechservice.solver.closure.model;

import java.util.Arrays;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.PivotedElimination;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * A partition chosen by full pivoting, which finds the largest pivots. Only restoring allocates
 * memory.
 */
final class DensePartition extends Partition {
  private final PivotedElimination elimination;
  private final PivotedElimination block;
  private final DenseLu factors;
  private final double[] scaled;
  private final double[] blockElements;

  /** Index of each unknown among the dependent ones, or -1. */
  private final int[] blockColumn;

  private final int[] rows;
  private final int[] columns;

  /** Number of pivots in the last matrix examined. */
  private int found;

  DensePartition(int equations, int unknowns, int rank) {
    super(equations, unknowns, rank);
    elimination = new PivotedElimination(m, n);
    block = new PivotedElimination(rank, rank);
    factors = new DenseLu(rank);
    scaled = new double[m * n];
    blockElements = new double[rank * rank];
    blockColumn = new int[n];
    rows = new int[rank];
    columns = new int[rank];
  }

  @Override
  boolean choose(SparseMatrix a) {
    formScaled(a);
    if (bestPivot(scaled) == 0) {
      return false;
    }
    takeChoice();
    return true;
  }

  private void formScaled(SparseMatrix a) {
    Arrays.fill(scaled, 0);
    for (int i = 0; i < m; i++) {
      for (int e = a.start[i]; e < a.start[i + 1] && a.column[e] < n; e++) {
        int j = a.column[e];
        scaled[i * n + j] = rowScale[i] * a.value[e] * columnScale[j];
      }
    }
  }

  private void takeChoice() {
    for (int k = 0; k < rank; k++) {
      rows[k] = elimination.row(k);
      columns[k] = elimination.column(k);
    }
    take(rows, columns);
  }

  @Override
  boolean chooseBetter(SparseMatrix a, double bound) {
    formScaled(a);
    if (!(bestPivot(scaled) > bound)) {
      return false;
    }
    takeChoice();
    return true;
  }

  @Override
  int scaledLength() {
    return scaled.length;
  }

  @Override
  double[] scaled() {
    return scaled;
  }

  @Override
  double bestPivot(double[] elements) {
    found = elimination.eliminate(elements, rank);
    return bestPivot();
  }

  @Override
  double bestPivot() {
    return rank == 0 ? 1 : found < rank ? 0 : elimination.pivot(rank - 1);
  }

  @Override
  int weakestRow() {
    return rank == 0 ? 0 : elimination.row(rank - 1);
  }

  @Override
  double smallestPivot(SparseMatrix a) {
    if (rank == 0) {
      return 1;
    }
    formBlock(a);
    for (int i = 0; i < rank; i++) {
      for (int j = 0; j < rank; j++) {
        blockElements[i * rank + j] =
            rowScale[kept[i]] * blockElements[i * rank + j] * columnScale[dependent[j]];
      }
    }
    return block.eliminate(blockElements, rank) < rank ? 0 : block.pivot(rank - 1);
  }

  private void formBlock(SparseMatrix a) {
    Arrays.fill(blockElements, 0);
    Arrays.fill(blockColumn, -1);
    for (int j = 0; j < rank; j++) {
      blockColumn[dependent[j]] = j;
    }
    for (int i = 0; i < rank; i++) {
      for (int e = a.start[kept[i]]; e < a.start[kept[i] + 1] && a.column[e] < n; e++) {
        if (blockColumn[a.column[e]] >= 0) {
          blockElements[i * rank + blockColumn[a.column[e]]] = a.value[e];
        }
      }
    }
  }

  @Override
  boolean factor(SparseMatrix a) {
    formBlock(a);
    return factors.factor(blockElements) == LinearSolver.NONSINGULAR;
  }

  @Override
  int orientation() {
    return factors.signOfDeterminant();
  }

  @Override
  void solve(double[] b) {
    factors.solve(b);
  }

  @Override
  void solveTransposed(double[] b) {
    factors.solveTransposed(b);
  }
}
