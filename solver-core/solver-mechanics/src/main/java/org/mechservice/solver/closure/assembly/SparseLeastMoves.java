package org.mechservice.solver.closure.assembly;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import org.mechservice.solver.linear.SparseMatrix;
import org.mechservice.solver.linear.SparseSymmetric;

/**
 * Least solution by factors of A Aᵀ + ε, which is regular even if equations are redundant: x = Aᵀ
 * (A Aᵀ + ε)⁻¹ b, iterated to remove the error of ε.
 */
final class SparseLeastMoves implements LeastMoves {
  /**
   * ε relative to the size of A Aᵀ; elements smaller than its square root relative to A are taken
   * as zero.
   */
  private static final double REGULAR = 1e-14;

  private static final int REPETITIONS = 4;

  private final int rows;
  private final int columns;
  private final SparseMatrix pattern;

  /**
   * Elements by columns, in the order of elimination within each column, and the indices of their
   * rows.
   */
  private final int[] columnStart;

  private final int[] elementAt;
  private final int[] place;
  private final double[] gathered;
  private final SparseSymmetric square;
  private final double[] element;
  private final double[] left;
  private final double[] remaining;
  private double size;
  private double factoredWith = -1;

  /**
   * @param columns number of leading columns of the matrix that are used
   */
  SparseLeastMoves(SparseMatrix pattern, int columns) {
    rows = pattern.rows();
    this.columns = columns;
    this.pattern = pattern;
    int[] rowOf = new int[pattern.column.length];
    List<List<Integer>> elements = new ArrayList<>();
    for (int j = 0; j < columns; j++) {
      elements.add(new ArrayList<>());
    }
    for (int row = 0; row < rows; row++) {
      for (int e = pattern.start[row]; e < pattern.start[row + 1]; e++) {
        rowOf[e] = row;
        if (pattern.column[e] < columns) {
          elements.get(pattern.column[e]).add(e);
        }
      }
    }
    List<int[]> cliques = new ArrayList<>();
    elements.forEach(list -> cliques.add(list.stream().mapToInt(e -> rowOf[e]).toArray()));
    square = new SparseSymmetric(rows, cliques, new int[0]);
    columnStart = new int[columns + 1];
    for (int j = 0; j < columns; j++) {
      elements.get(j).sort((a, b) -> square.placeOf(rowOf[a]) - square.placeOf(rowOf[b]));
      columnStart[j + 1] = columnStart[j] + elements.get(j).size();
    }
    elementAt = elements.stream().flatMap(List::stream).mapToInt(Integer::intValue).toArray();
    place = Arrays.stream(elementAt).map(e -> square.placeOf(rowOf[e])).toArray();
    gathered = new double[elementAt.length];
    element = new double[pattern.column.length];
    left = new double[rows];
    remaining = new double[columns];
  }

  @Override
  public void take(SparseMatrix matrix) {
    System.arraycopy(matrix.value, 0, element, 0, element.length);
    for (int i = 0; i < elementAt.length; i++) {
      gathered[i] = element[elementAt[i]];
    }
    form();
    size = square.norm();
    factoredWith = -1;
  }

  private void form() {
    square.clear();
    for (int j = 0; j < columns; j++) {
      int at = columnStart[j];
      square.addSquare(place, at, gathered, at, columnStart[j + 1] - at, 1);
    }
  }

  /** Factors A Aᵀ + part · size. */
  private void factor(double part) {
    if (part == factoredWith) {
      return;
    }
    form();
    for (int row = 0; row < rows; row++) {
      square.addDiagonal(square.placeOf(row), part * (size > 0 ? size : 1));
    }
    if (square.factor() != SparseSymmetric.POSITIVE_DEFINITE) {
      factor(Math.max(100 * part, REGULAR));
    }
    factoredWith = part;
  }

  @Override
  public void solve(double damping, double[] right, double[] x) {
    factor(Math.max(damping, REGULAR));
    Arrays.fill(x, 0, columns, 0);
    int repetitions = damping > 0 ? 1 : REPETITIONS;
    for (int i = 0; i < repetitions; i++) {
      for (int row = 0; row < rows; row++) {
        left[row] = right[row] - product(row, x);
      }
      square.solve(left);
      for (int row = 0; row < rows; row++) {
        addRow(row, left[row], x);
      }
    }
  }

  @Override
  public OptionalDouble largestOverSmallest() {
    return OptionalDouble.empty();
  }

  @Override
  public void solveTransposed(double[] right, double[] x) {
    factor(REGULAR);
    Arrays.fill(x, 0, rows, 0);
    for (int i = 0; i < REPETITIONS; i++) {
      System.arraycopy(right, 0, remaining, 0, columns);
      for (int row = 0; row < rows; row++) {
        addRow(row, -x[row], remaining);
      }
      for (int row = 0; row < rows; row++) {
        left[row] = product(row, remaining);
      }
      square.solve(left);
      for (int row = 0; row < rows; row++) {
        x[row] += left[row];
      }
    }
  }

  private double product(int row, double[] x) {
    double sum = 0;
    for (int e = pattern.start[row]; e < pattern.start[row + 1]; e++) {
      if (pattern.column[e] < columns) {
        sum += element[e] * x[pattern.column[e]];
      }
    }
    return sum;
  }

  private void addRow(int row, double factor, double[] x) {
    for (int e = pattern.start[row]; e < pattern.start[row + 1]; e++) {
      if (pattern.column[e] < columns) {
        x[pattern.column[e]] += factor * element[e];
      }
    }
  }
}
