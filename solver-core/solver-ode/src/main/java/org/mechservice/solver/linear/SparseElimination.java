package org.mechservice.solver.linear;

import java.util.Arrays;

/**
 * Gaussian elimination of an m × n sparse matrix that chooses its pivots for size and for few new
 * elements at once: which columns are found from the others, and by which rows, as {@link
 * PivotedElimination} says for dense matrices (Duff, Erisman and Reid 2017, ch. 7: Markowitz counts
 * with a threshold).
 *
 * <p>A pivot is at least half of the largest element that its row has left, so that what is found
 * from other columns is never found from much larger changes of them. Rows wait while all that they
 * have left is small beside what others have: those that repeat others come last, and what is left
 * of them is rounding. Pivots depend on the scaling of rows and columns; the caller scales them to
 * what is comparable.
 *
 * <p>For setting up and for a choice made anew now and then: allocates.
 */
public final class SparseElimination {
  /** A pivot is at least this part of the largest element left in its row. */
  private static final double OF_ROW = 0.5;

  /** Rows wait while what they have left is below these parts of the largest element at first. */
  private static final double[] STAGES = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 0};

  /** Rows looked at for each pivot once one with a pivot is found. */
  private static final int CANDIDATES = 4;

  private final int m;
  private final int n;
  private final ActiveRows active;
  private final int[] row;
  private final int[] column;
  private final double[] pivot;

  /** Rows that eliminated each pivot row's elements before, in the order of the steps. */
  private final int[][] lower;

  private final int[] lowerCount;
  private final int[] stepOfRow;
  private int eliminated;
  private double largestAtFirst;

  /**
   * @param rows m
   * @param columns n, of which {@link #eliminate} takes no elements beyond
   */
  public SparseElimination(int rows, int columns) {
    m = rows;
    n = columns;
    active = new ActiveRows(m, n);
    row = new int[m];
    column = new int[Math.min(m, n)];
    pivot = new double[Math.min(m, n)];
    lower = new int[m][];
    lowerCount = new int[m];
    stepOfRow = new int[m];
  }

  /**
   * Eliminates until no pivot above a bound is left or enough are found.
   *
   * @param matrix whose first n columns count; not modified
   * @param steps the most pivots wanted
   * @param bound of pivots, as a part of the largest element of the matrix
   * @return the number of pivots found
   */
  public int eliminate(SparseMatrix matrix, int steps, double bound) {
    active.load(matrix);
    Arrays.fill(stepOfRow, -1);
    Arrays.fill(lowerCount, 0);
    eliminated = 0;
    largestAtFirst = active.largest();
    for (double stage : STAGES) {
      double least = Math.max(stage, bound) * largestAtFirst;
      eliminateAbove(least, Math.min(steps, pivot.length));
    }
    int last = eliminated;
    for (int i = 0; i < m; i++) {
      if (stepOfRow[i] < 0) {
        row[last++] = i;
      }
    }
    return eliminated;
  }

  private void eliminateAbove(double least, int steps) {
    active.reactivate();
    while (eliminated < steps) {
      Interruption.check();
      int found = active.choose(least, OF_ROW, CANDIDATES);
      if (found < 0) {
        return;
      }
      eliminate(found, active.chosenColumn());
    }
  }

  private void eliminate(int pivotRow, int pivotColumn) {
    row[eliminated] = pivotRow;
    column[eliminated] = pivotColumn;
    pivot[eliminated] = Math.abs(active.chosenElement());
    stepOfRow[pivotRow] = eliminated;
    for (int other : active.rowsOf(pivotColumn)) {
      boolean waits = other >= 0 && other != pivotRow && stepOfRow[other] < 0;
      if (waits && active.has(other, pivotColumn)) {
        active.subtract(pivotRow, other, pivotColumn);
        note(other);
      }
    }
    active.remove(pivotRow);
    eliminated++;
  }

  /**
   * Eliminates by pivots that were chosen before, for the elements that are new then; the matrix
   * counts by its pattern alone.
   *
   * @param rows of the pivots, in their order
   * @param columns of the pivots
   */
  public void repeat(SparseMatrix matrix, int[] rows, int[] columns) {
    active.load(matrix);
    Arrays.fill(stepOfRow, -1);
    Arrays.fill(lowerCount, 0);
    eliminated = 0;
    active.reactivate();
    for (int k = 0; k < rows.length; k++) {
      active.choose(rows[k], columns[k]);
      eliminate(rows[k], columns[k]);
    }
  }

  private void note(int other) {
    if (lower[other] == null) {
      lower[other] = new int[4];
    } else if (lowerCount[other] == lower[other].length) {
      lower[other] = Arrays.copyOf(lower[other], 2 * lower[other].length);
    }
    lower[other][lowerCount[other]++] = eliminated;
  }

  /** Returns the row that gave pivot k, or, for k beyond the pivots, those that gave none. */
  public int row(int k) {
    return row[k];
  }

  /** Returns the column of pivot k. */
  public int column(int k) {
    return column[k];
  }

  /** Returns the absolute value of pivot k. */
  public double pivot(int k) {
    return pivot[k];
  }

  /** Returns the smallest pivot of the last {@link #eliminate}; 1 if there is none. */
  public double smallestPivot() {
    int weakest = weakest();
    return weakest < 0 ? 1 : pivot[weakest];
  }

  /** Returns which pivot was smallest, or -1. */
  public int weakest() {
    int weakest = -1;
    for (int k = 0; k < eliminated; k++) {
      weakest = weakest < 0 || pivot[k] < pivot[weakest] ? k : weakest;
    }
    return weakest;
  }

  /** Returns the smallest pivot over the largest element of the matrix; 1 without pivots. */
  public double smallestOverLargest() {
    return eliminated == 0 ? 1 : smallestPivot() / largestAtFirst;
  }

  /** Returns the steps, ascending, that changed the row of pivot k before it was chosen. */
  int[] lower(int k) {
    int i = row[k];
    return lowerCount[i] == 0 ? new int[0] : Arrays.copyOf(lower[i], lowerCount[i]);
  }

  /** Returns the columns, in no order, that the row of pivot k had left when it was chosen. */
  int[] upper(int k) {
    return active.columnsOf(row[k]);
  }

  /** Returns the largest element that is left in the rows without pivots. */
  public double largestLeft() {
    return active.largestWaiting();
  }

  /** Returns the columns, in no order, in which row k of those without pivots has elements left. */
  public int[] columnsLeft(int k) {
    return active.columnsOf(row[k]);
  }

  /** Returns what row k of those without pivots has left, in the order of {@link #columnsLeft}. */
  public double[] elementsLeft(int k) {
    return active.elementsOf(row[k]);
  }
}
