package org.mechservice.solver.linear;

import java.util.Arrays;

/**
 * The rows of a sparse matrix while it is eliminated: each a growing list of elements, and for each
 * column the rows that may have an element there. Rows that still wait for a pivot are in lists by
 * their number of elements, shortest first.
 */
final class ActiveRows {
  private final int m;
  private final int n;
  private final int[][] columns;
  private final double[][] elements;
  private final int[] length;

  /** Rows that have had an element in each column; some more than once or no more. */
  private final int[][] rows;

  private final int[] rowCount;

  /** Elements of each column in rows that wait. */
  private final int[] inColumn;

  /** Doubly linked lists of the rows that may be chosen, by their length. */
  private final int[] first;

  private final int[] next;
  private final int[] before;
  private final boolean[] listed;
  private final boolean[] removed;

  /** Where the columns of the row in hand stand in another; -1 elsewhere. */
  private final int[] place;

  private int chosenColumn;
  private double chosenElement;

  ActiveRows(int m, int n) {
    this.m = m;
    this.n = n;
    columns = new int[m][];
    elements = new double[m][];
    length = new int[m];
    rows = new int[n][4];
    rowCount = new int[n];
    inColumn = new int[n];
    first = new int[n + 1];
    next = new int[m];
    before = new int[m];
    listed = new boolean[m];
    removed = new boolean[m];
    place = new int[n];
    Arrays.fill(place, -1);
  }

  /** Takes a matrix: zeros of its pattern too, which are none in matrices of the same pattern. */
  void load(SparseMatrix matrix) {
    Arrays.fill(first, -1);
    Arrays.fill(rowCount, 0);
    Arrays.fill(inColumn, 0);
    Arrays.fill(listed, false);
    Arrays.fill(removed, false);
    for (int i = 0; i < m; i++) {
      int size = matrix.start[i + 1] - matrix.start[i];
      if (columns[i] == null || columns[i].length < size) {
        columns[i] = new int[size + 4];
        elements[i] = new double[size + 4];
      }
      length[i] = 0;
      for (int e = matrix.start[i]; e < matrix.start[i + 1]; e++) {
        if (matrix.column[e] < n) {
          append(i, matrix.column[e], matrix.value[e]);
        }
      }
    }
  }

  private void append(int i, int j, double element) {
    if (length[i] == columns[i].length) {
      columns[i] = Arrays.copyOf(columns[i], 2 * length[i] + 4);
      elements[i] = Arrays.copyOf(elements[i], 2 * length[i] + 4);
    }
    columns[i][length[i]] = j;
    elements[i][length[i]++] = element;
    if (rowCount[j] == rows[j].length) {
      rows[j] = Arrays.copyOf(rows[j], 2 * rowCount[j]);
    }
    rows[j][rowCount[j]++] = i;
    inColumn[j]++;
  }

  double largest() {
    double largest = 0;
    for (int i = 0; i < m; i++) {
      largest = Math.max(largest, largestOf(i));
    }
    return largest;
  }

  /** Returns the largest element of the rows that have not been removed. */
  double largestWaiting() {
    double largest = 0;
    for (int i = 0; i < m; i++) {
      largest = Math.max(largest, removed[i] ? 0 : largestOf(i));
    }
    return largest;
  }

  private double largestOf(int i) {
    double largest = 0;
    for (int e = 0; e < length[i]; e++) {
      largest = Math.max(largest, Math.abs(elements[i][e]));
    }
    return largest;
  }

  /** Permits the choice of all rows that are left. */
  void reactivate() {
    for (int i = m - 1; i >= 0; i--) {
      if (!removed[i] && !listed[i]) {
        list(i);
      }
    }
  }

  private void list(int i) {
    int head = first[length[i]];
    next[i] = head;
    before[i] = -1;
    if (head >= 0) {
      before[head] = i;
    }
    first[length[i]] = i;
    listed[i] = true;
  }

  private void unlist(int i) {
    if (before[i] >= 0) {
      next[before[i]] = next[i];
    } else {
      first[length[i]] = next[i];
    }
    if (next[i] >= 0) {
      before[next[i]] = before[i];
    }
    listed[i] = false;
  }

  /**
   * Chooses a pivot among the shortest rows: the one that makes the fewest new elements at most.
   * Rows that have nothing left of the least size wait from now on.
   *
   * @return its row, or -1
   */
  int choose(double least, double ofRow, int candidates) {
    int best = -1;
    long bestCount = Long.MAX_VALUE;
    double bestElement = 0;
    int looked = 0;
    for (int size = 1; size <= n && looked < candidates; size++) {
      if (bestCount <= (long) (size - 1) * (size - 1)) {
        break;
      }
      for (int i = first[size]; i >= 0 && looked < candidates; ) {
        int following = next[i];
        double largest = largestOf(i);
        if (!(largest > least) || !Double.isFinite(largest)) {
          unlist(i);
        } else {
          looked++;
          for (int e = 0; e < length[i]; e++) {
            double element = Math.abs(elements[i][e]);
            long count = (long) (size - 1) * (inColumn[columns[i][e]] - 1);
            boolean better = count < bestCount || (count == bestCount && element > bestElement);
            if (element >= ofRow * largest && better) {
              best = i;
              bestCount = count;
              bestElement = element;
              chosenColumn = columns[i][e];
              chosenElement = elements[i][e];
            }
          }
        }
        i = following;
      }
    }
    return best;
  }

  /** Takes a pivot that was chosen before. */
  void choose(int i, int j) {
    chosenColumn = j;
    chosenElement = elements[i][find(i, j)];
  }

  int chosenColumn() {
    return chosenColumn;
  }

  double chosenElement() {
    return chosenElement;
  }

  /** Returns the rows that may have an element in a column, some twice. */
  int[] rowsOf(int j) {
    int[] found = Arrays.copyOf(rows[j], rowCount[j]);
    Arrays.sort(found);
    for (int k = 1; k < found.length; k++) {
      if (found[k] == found[k - 1]) {
        found[k - 1] = -1;
      }
    }
    return found;
  }

  boolean has(int i, int j) {
    return find(i, j) >= 0;
  }

  private int find(int i, int j) {
    for (int e = 0; e < length[i]; e++) {
      if (columns[i][e] == j) {
        return e;
      }
    }
    return -1;
  }

  /** Subtracts the row of a pivot, so that another has nothing in the pivot's column. */
  void subtract(int pivotRow, int other, int pivotColumn) {
    if (listed[other]) {
      unlist(other);
    }
    int at = find(other, pivotColumn);
    double factor = elements[other][at] / chosenElement;
    length[other]--;
    columns[other][at] = columns[other][length[other]];
    elements[other][at] = elements[other][length[other]];
    for (int e = 0; e < length[other]; e++) {
      place[columns[other][e]] = e;
    }
    for (int e = 0; e < length[pivotRow]; e++) {
      int j = columns[pivotRow][e];
      if (j == pivotColumn) {
        continue;
      }
      if (place[j] >= 0) {
        elements[other][place[j]] -= factor * elements[pivotRow][e];
      } else {
        append(other, j, -factor * elements[pivotRow][e]);
        place[j] = length[other] - 1;
      }
    }
    for (int e = 0; e < length[other]; e++) {
      place[columns[other][e]] = -1;
    }
    inColumn[pivotColumn]--;
    list(other);
  }

  /** Takes a pivot's row out; its elements stay to be read. */
  void remove(int i) {
    if (listed[i]) {
      unlist(i);
    }
    removed[i] = true;
    for (int e = 0; e < length[i]; e++) {
      inColumn[columns[i][e]]--;
    }
  }

  int[] columnsOf(int i) {
    return Arrays.copyOf(columns[i], length[i]);
  }

  double[] elementsOf(int i) {
    return Arrays.copyOf(elements[i], length[i]);
  }
}
