package org.mechservice.solver.dynamics.derivative;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.mechservice.solver.linear.SparseLayout;

/**
 * A sparse square matrix that is put together from elements in an order that never changes. The
 * first pass learns where they are, later ones add their values. Workspace of one thread.
 */
final class SparseAssembly {
  private final int size;

  /** Elements of the first pass. */
  private int[] row = new int[64];

  private int[] column = new int[64];
  private boolean learning = true;

  /** Places of the elements in the values, in their order. */
  private int[] place = {};

  private double[] values = {};
  private int next;

  /**
   * Makes an assembly for a first pass.
   *
   * @param size of the matrix
   */
  SparseAssembly(int size) {
    this.size = size;
  }

  /** Adds to an element; a value of the first pass does not count. */
  void put(int i, int j, double value) {
    if (!learning) {
      values[place[next++]] += value;
      return;
    }
    if (next == row.length) {
      row = Arrays.copyOf(row, 2 * next);
      column = Arrays.copyOf(column, 2 * next);
    }
    row[next] = i;
    column[next++] = j;
  }

  /** Ends the first pass and returns the layout of the matrix. */
  SparseLayout learn() {
    SparseLayout layout = SparseLayout.of(pattern());
    place = new int[next];
    for (int e = 0; e < next; e++) {
      place[e] = layout.index(row[e], column[e]);
    }
    row = new int[0];
    column = new int[0];
    values = new double[layout.length()];
    learning = false;
    return layout;
  }

  /** Returns the rows of each column of what has been put. */
  private int[][] pattern() {
    int[] counts = new int[size];
    for (int e = 0; e < next; e++) {
      counts[column[e]]++;
    }
    int[][] columns = new int[size][];
    Arrays.setAll(columns, j -> new int[counts[j]]);
    for (int e = 0; e < next; e++) {
      int j = column[e];
      columns[j][--counts[j]] = row[e];
    }
    Arrays.setAll(columns, j -> IntStream.of(columns[j]).sorted().distinct().toArray());
    return columns;
  }

  /** Begins another pass, with a matrix of zeros. */
  void clear() {
    Arrays.fill(values, 0);
    next = 0;
  }

  /** Returns the elements of the last pass in the layout of {@link #learn}. */
  double[] values() {
    return values;
  }
}
