package org.mechservice.solver.closure.assembly;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.mechservice.solver.linear.PivotedElimination;
import org.mechservice.solver.linear.SparseElimination;
import org.mechservice.solver.linear.SparseMatrix;
import org.mechservice.solver.linear.spectrum.SingularValues;

/**
 * Rank by sparse elimination while pivots are clearly nonzero, then by singular values of the few
 * rows that remain.
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
    int[] names = new int[doubtful];
    Arrays.setAll(names, i -> elimination.row(clear + i));
    double least = clear == 0 ? 1 : elimination.smallestPivot();
    double part = elimination.smallestOverLargest();
    int found = 0;
    if (doubtful > 0 && !(elimination.largestLeft() * doubtful <= least * NEGLIGIBLE / GAP)) {
      double[] left = withoutEmptyColumns(elimination.remainder(), doubtful, columns);
      int width = left.length / doubtful;
      found = rank(left, doubtful, width, least);
      PivotedElimination among = new PivotedElimination(doubtful, width);
      found = among.eliminate(left, found);
      int[] order = new int[doubtful];
      Arrays.setAll(order, i -> names[among.row(i)]);
      System.arraycopy(order, 0, names, 0, doubtful);
      part = found == 0 ? part : part * among.pivot(found - 1) / least;
    }
    rank = clear + found;
    smallestPivot = part;
    Arrays.stream(names, found, doubtful).sorted().forEach(redundant::add);
  }

  private static double[] withoutEmptyColumns(double[] left, int rows, int columns) {
    BitSet used = new BitSet();
    for (int i = 0; i < left.length; i++) {
      if (left[i] != 0) {
        used.set(i % columns);
      }
    }
    int[] kept = used.stream().toArray();
    double[] narrow = new double[rows * kept.length];
    for (int row = 0; row < rows; row++) {
      for (int j = 0; j < kept.length; j++) {
        narrow[row * kept.length + j] = left[row * columns + kept[j]];
      }
    }
    return narrow;
  }

  /**
   * Returns the number of singular values before the gap; the largest of the eliminated rows counts
   * as 1.
   */
  private static int rank(double[] left, int rows, int columns, double least) {
    SingularValues singular = new SingularValues(rows, columns);
    singular.decompose(left);
    double before = least;
    int found = 0;
    for (; found < Math.min(rows, columns); found++) {
      double value = singular.value(found);
      if (value <= NEGLIGIBLE && value * GAP <= before) {
        return found;
      }
      before = value;
    }
    return found;
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
