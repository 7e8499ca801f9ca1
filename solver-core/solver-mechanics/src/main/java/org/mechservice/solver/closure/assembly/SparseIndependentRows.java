package org.mechservice.solver.closure.assembly;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.mechservice.solver.linear.SparseElimination;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * Rank by sparse elimination while pivots are clearly nonzero, then by singular values of the rows
 * that remain. Remaining rows that share no column, directly or by others, have singular values of
 * their own, so that each group of rows is decomposed alone.
 */
final class SparseIndependentRows implements IndependentRows {
  /** Fraction of the largest element above which a pivot is clearly nonzero. */
  private static final double DOUBTLESS = 1e-5;

  private final int rank;
  private final List<Integer> redundant = new ArrayList<>();
  private final double smallestPivot;

  /**
   * @param columns of the matrix that count, the first ones
   */
  SparseIndependentRows(SparseMatrix matrix, int columns) {
    SparseElimination elimination = new SparseElimination(matrix.rows(), columns);
    int clear = elimination.eliminate(matrix, matrix.rows(), DOUBTLESS);
    int doubtful = matrix.rows() - clear;
    double least = clear == 0 ? 1 : elimination.smallestPivot();
    double part = elimination.smallestOverLargest();
    int found = 0;
    if (doubtful > 0 && !(elimination.largestLeft() * doubtful <= least * NEGLIGIBLE / GAP)) {
      List<DoubtfulRows> groups = DoubtfulRows.groups(elimination, clear, doubtful, columns);
      share(groups, least);
      double smallest = Double.POSITIVE_INFINITY;
      for (DoubtfulRows group : groups) {
        smallest = Math.min(smallest, group.choose());
        redundant.addAll(group.redundant());
      }
      found = doubtful - redundant.size();
      part = found == 0 ? part : part * smallest / least;
    } else {
      for (int k = clear; k < matrix.rows(); k++) {
        redundant.add(elimination.row(k));
      }
    }
    redundant.sort(Comparator.naturalOrder());
    rank = clear + found;
    smallestPivot = part;
  }

  /**
   * Tells each group how many of the singular values before the gap are its own; the largest of the
   * eliminated rows counts as 1.
   */
  private static void share(List<DoubtfulRows> groups, double least) {
    record Value(double size, DoubtfulRows group) {}
    Value[] values =
        groups.stream()
            .flatMap(group -> Arrays.stream(group.values()).mapToObj(v -> new Value(v, group)))
            .sorted(Comparator.comparingDouble(Value::size).reversed())
            .toArray(Value[]::new);
    double before = least;
    for (Value value : values) {
      if (value.size() <= NEGLIGIBLE && value.size() * GAP <= before) {
        return;
      }
      value.group().take();
      before = value.size();
    }
  }

  @Override
  public int rank() {
    return rank;
  }

  @Override
  public List<Integer> redundant() {
    return redundant;
  }

  @Override
  public double smallestPivot() {
    return smallestPivot;
  }
}
