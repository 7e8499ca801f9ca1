package org.mechservice.solver.linear;

import java.util.Arrays;

/**
 * Factors of the square block of a sparse matrix that {@link SparseElimination} has chosen, in the
 * order of its pivots and with the elements that it found to be new: to be formed again and again
 * while the matrix changes little (Davis 2006, ch. 6).
 *
 * <p>Rows and columns are scaled first, so that pivots are comparable. A workspace for one thread;
 * nothing allocates after construction.
 */
public final class SparseLu {
  private final int size;
  private final int[] row;
  private final int[] column;

  /** Step in which each column of the matrix is eliminated, or -1. */
  private final int[] stepOfColumn;

  /** Steps that change each row before its own, ascending, and what they are multiplied by. */
  private final int[] lowerStart;

  private final int[] lowerStep;
  private final double[] lower;

  /** Steps of the columns right of each pivot, and the elements there. */
  private final int[] upperStart;

  private final int[] upperStep;
  private final double[] upper;

  private final double[] pivot;
  private final double[] rowScale;
  private final double[] columnScale;
  private final double[] work;
  private double smallest;
  private int weakest;

  /**
   * Takes over a choice.
   *
   * @param chosen has eliminated
   * @param steps how many of its pivots belong to the block
   * @param columns of the matrix
   */
  public SparseLu(SparseElimination chosen, int steps, int columns) {
    size = steps;
    row = new int[size];
    column = new int[size];
    stepOfColumn = new int[columns];
    Arrays.fill(stepOfColumn, -1);
    for (int k = 0; k < size; k++) {
      row[k] = chosen.row(k);
      column[k] = chosen.column(k);
      stepOfColumn[column[k]] = k;
    }
    lowerStart = new int[size + 1];
    upperStart = new int[size + 1];
    int[][] lowers = new int[size][];
    int[][] uppers = new int[size][];
    for (int k = 0; k < size; k++) {
      int own = k;
      lowers[k] = chosen.lower(k);
      uppers[k] =
          Arrays.stream(chosen.upper(k))
              .map(j -> stepOfColumn[j])
              .filter(s -> s > own)
              .sorted()
              .toArray();
      lowerStart[k + 1] = lowerStart[k] + lowers[k].length;
      upperStart[k + 1] = upperStart[k] + uppers[k].length;
    }
    lowerStep = Arrays.stream(lowers).flatMapToInt(Arrays::stream).toArray();
    upperStep = Arrays.stream(uppers).flatMapToInt(Arrays::stream).toArray();
    lower = new double[lowerStep.length];
    upper = new double[upperStep.length];
    pivot = new double[size];
    rowScale = new double[size];
    columnScale = new double[size];
    work = new double[size];
  }

  private SparseLu(SparseLu other) {
    size = other.size;
    row = other.row;
    column = other.column;
    stepOfColumn = other.stepOfColumn;
    lowerStart = other.lowerStart;
    lowerStep = other.lowerStep;
    upperStart = other.upperStart;
    upperStep = other.upperStep;
    lower = new double[lowerStep.length];
    upper = new double[upperStep.length];
    pivot = new double[size];
    rowScale = new double[size];
    columnScale = new double[size];
    work = new double[size];
  }

  /** Returns factors of the same block in the same order, with numbers of their own. */
  public SparseLu sameOrder() {
    return new SparseLu(this);
  }

  /** Returns how many rows and columns the block has. */
  public int size() {
    return size;
  }

  /** Returns the row of the matrix that is eliminated in a step. */
  public int row(int step) {
    return row[step];
  }

  /** Returns the column of the matrix that is eliminated in a step. */
  public int column(int step) {
    return column[step];
  }

  /**
   * Factors.
   *
   * @param matrix of the pattern that the choice was made in; not modified
   * @param ofRows what its rows are multiplied by first; not zero
   * @param ofColumns what its columns are multiplied by first; not zero
   * @return whether every pivot is finite and differs from zero
   */
  public boolean factor(SparseMatrix matrix, double[] ofRows, double[] ofColumns) {
    smallest = 1;
    weakest = -1;
    for (int k = 0; k < size; k++) {
      rowScale[k] = ofRows[row[k]];
      columnScale[k] = ofColumns[column[k]];
    }
    for (int k = 0; k < size; k++) {
      clear(k);
      scatter(matrix, k);
      for (int e = lowerStart[k]; e < lowerStart[k + 1]; e++) {
        int step = lowerStep[e];
        double factor = work[step] / pivot[step];
        lower[e] = factor;
        for (int u = upperStart[step]; u < upperStart[step + 1]; u++) {
          work[upperStep[u]] -= factor * upper[u];
        }
      }
      for (int u = upperStart[k]; u < upperStart[k + 1]; u++) {
        upper[u] = work[upperStep[u]];
      }
      if (!accept(k, work[k])) {
        return false;
      }
    }
    return true;
  }

  private void clear(int k) {
    for (int e = lowerStart[k]; e < lowerStart[k + 1]; e++) {
      work[lowerStep[e]] = 0;
    }
    for (int u = upperStart[k]; u < upperStart[k + 1]; u++) {
      work[upperStep[u]] = 0;
    }
    work[k] = 0;
  }

  private void scatter(SparseMatrix matrix, int k) {
    for (int e = matrix.start[row[k]]; e < matrix.start[row[k] + 1]; e++) {
      int j = matrix.column[e];
      int step = j < stepOfColumn.length ? stepOfColumn[j] : -1;
      if (step >= 0) {
        work[step] = rowScale[k] * matrix.value[e] * columnScale[step];
      }
    }
  }

  private boolean accept(int k, double element) {
    pivot[k] = element;
    double part = Math.abs(element);
    if (!(part >= smallest) || weakest < 0) {
      smallest = part;
      weakest = k;
    }
    return part > 0 && part < Double.POSITIVE_INFINITY;
  }

  /** Returns the smallest pivot of the last {@link #factor}; 1 if there are none. */
  public double smallestPivot() {
    return size == 0 ? 1 : smallest;
  }

  /**
   * Returns the sign of the determinant of the last block factored, its rows and columns in the
   * order of the steps.
   */
  public int signOfDeterminant() {
    int sign = 1;
    for (int k = 0; k < size; k++) {
      sign = pivot[k] < 0 ? -sign : sign;
    }
    return sign;
  }

  /**
   * Solves with the last factors.
   *
   * @param b one number per step, in the order of the steps: of its row before, of its column after
   */
  public void solve(double[] b) {
    for (int k = 0; k < size; k++) {
      double sum = rowScale[k] * b[k];
      for (int e = lowerStart[k]; e < lowerStart[k + 1]; e++) {
        sum -= lower[e] * b[lowerStep[e]];
      }
      b[k] = sum;
    }
    for (int k = size - 1; k >= 0; k--) {
      double sum = b[k];
      for (int u = upperStart[k]; u < upperStart[k + 1]; u++) {
        sum -= upper[u] * b[upperStep[u]];
      }
      b[k] = sum / pivot[k];
    }
    for (int k = 0; k < size; k++) {
      b[k] *= columnScale[k];
    }
  }

  /**
   * Solves with the transposed factors.
   *
   * @param b one number per step: of its column before, of its row after
   */
  public void solveTransposed(double[] b) {
    for (int k = 0; k < size; k++) {
      b[k] *= columnScale[k];
    }
    for (int k = 0; k < size; k++) {
      b[k] /= pivot[k];
      for (int u = upperStart[k]; u < upperStart[k + 1]; u++) {
        b[upperStep[u]] -= upper[u] * b[k];
      }
    }
    for (int k = size - 1; k >= 0; k--) {
      for (int e = lowerStart[k]; e < lowerStart[k + 1]; e++) {
        b[lowerStep[e]] -= lower[e] * b[k];
      }
    }
    for (int k = 0; k < size; k++) {
      b[k] *= rowScale[k];
    }
  }
}
