package org.mechservice.solver.closure.model;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.linear.SparseMatrix;
import org.mechservice.solver.linear.SparseSymmetric;

/** Sparse factors of J U² Jᵀ: their cost follows the couplings of a large mechanism. */
final class SparsePositionCorrection implements PositionCorrection {
  private final SparseMatrix rows;
  private final double[] units;
  private final SparseSymmetric square;

  /** The places in {@link #square} that each column of J couples, and their elements of J. */
  private final int[] start;

  private final int[] places;
  private final int[] elements;
  private final double[] values;

  /**
   * Makes a workspace.
   *
   * @param rows J, to be written before each {@link #factor}
   * @param units U of the columns
   */
  SparsePositionCorrection(SparseMatrix rows, double[] units) {
    this.rows = rows;
    this.units = units;
    int m = rows.rows();
    List<List<int[]>> columns = new ArrayList<>();
    for (int j = 0; j < units.length; j++) {
      columns.add(new ArrayList<>());
    }
    for (int row = 0; row < m; row++) {
      for (int e = rows.start[row]; e < rows.start[row + 1]; e++) {
        columns.get(rows.column[e]).add(new int[] {row, e});
      }
    }
    List<int[]> cliques =
        columns.stream()
            .map(column -> column.stream().mapToInt(element -> element[0]).toArray())
            .toList();
    square = new SparseSymmetric(m, cliques, new int[0]);
    start = new int[units.length + 1];
    places = new int[rows.column.length];
    elements = new int[rows.column.length];
    values = new double[rows.column.length];
    int at = 0;
    for (int j = 0; j < units.length; j++) {
      List<int[]> column = columns.get(j);
      column.sort((a, b) -> Integer.compare(square.placeOf(a[0]), square.placeOf(b[0])));
      for (int[] element : column) {
        places[at] = square.placeOf(element[0]);
        elements[at++] = element[1];
      }
      start[j + 1] = at;
    }
  }

  @Override
  public boolean factor() {
    square.clear();
    for (int i = 0; i < values.length; i++) {
      values[i] = rows.value[elements[i]];
    }
    for (int j = 0; j < units.length; j++) {
      int at = start[j];
      square.addSquare(places, at, values, at, start[j + 1] - at, units[j] * units[j]);
    }
    double largest = 0;
    for (int place = 0; place < square.size(); place++) {
      largest = Math.max(largest, square.pivot(place));
    }
    double regular = PositionCorrection.regularPart(largest);
    for (int place = 0; place < square.size(); place++) {
      square.addDiagonal(place, regular);
    }
    return square.factor() == SparseSymmetric.POSITIVE_DEFINITE;
  }

  @Override
  public void solve(double[] b) {
    square.solve(b);
  }
}
