package org.mechservice.solver.closure;

import java.util.Arrays;
import java.util.BitSet;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.linear.SparseLayout;
import org.mechservice.solver.linear.SparseMatrix;
import org.mechservice.solver.linear.SparsePivotedLu;

/**
 * Corrections by sparse factors of the equations in Δx and Δλ, without forming JᵀJ: its cost
 * follows the couplings of a large mechanism. Workspace of one thread.
 *
 * <p>With the units U of the unknowns and the largest element s of U A U the equations are factored
 * in numbers of like size: U A U / s, J U and s / α.
 */
public final class SparseAugmentedEquations extends AugmentedEquations {
  private final TreePattern pattern;
  private final SparsePivotedLu lu;
  private final double[] matrix;
  private final double[] both;

  /** Where the elements of A are in the matrix: diagonal by place, and by index of the pattern. */
  private final int[] diagonal;

  private final int[] lower;
  private final int[] upper;

  /** Where the elements of J, of Jᵀ and of 1/α are in the matrix. */
  private final int[] ofRow;

  private final int[] ofColumn;
  private final int[] ofPenalty;

  /** A of the last factorisation. */
  private final TreeSquare factored;

  /** s, the largest element on the diagonal of U A U. */
  private double size = 1;

  /**
   * Makes equations.
   *
   * @param rows J, to be written before each factorisation
   * @param units of the unknowns, which scale the columns of J
   * @param pattern of A
   */
  public SparseAugmentedEquations(SparseMatrix rows, double[] units, TreePattern pattern) {
    super(rows, units);
    this.pattern = pattern;
    SparseLayout layout = SparseLayout.of(columns());
    lu = new SparsePivotedLu(layout);
    matrix = new double[layout.length()];
    both = new double[n + m];
    diagonal = new int[n];
    lower = new int[pattern.column.length];
    upper = new int[pattern.column.length];
    for (int place = 0; place < n; place++) {
      int i = pattern.velocityAt[place];
      diagonal[place] = layout.index(i, i);
      for (int e = pattern.rowStart[place]; e < pattern.rowStart[place + 1]; e++) {
        int j = pattern.velocityAt[pattern.column[e]];
        lower[e] = layout.index(i, j);
        upper[e] = layout.index(j, i);
      }
    }
    ofRow = new int[rows.column.length];
    ofColumn = new int[rows.column.length];
    ofPenalty = new int[m];
    for (int row = 0; row < m; row++) {
      ofPenalty[row] = layout.index(n + row, n + row);
      for (int e = rows.start[row]; e < rows.start[row + 1]; e++) {
        ofRow[e] = layout.index(n + row, rows.column[e]);
        ofColumn[e] = layout.index(rows.column[e], n + row);
      }
    }
    factored = new TreeSquare(pattern);
  }

  /** Returns the rows of each column of the equations: n unknowns, then m multipliers. */
  private int[][] columns() {
    BitSet[] columns = new BitSet[n + m];
    Arrays.setAll(columns, column -> new BitSet());
    for (int place = 0; place < n; place++) {
      int i = pattern.velocityAt[place];
      for (int e = pattern.rowStart[place]; e < pattern.rowStart[place + 1]; e++) {
        int j = pattern.velocityAt[pattern.column[e]];
        columns[i].set(j);
        columns[j].set(i);
      }
    }
    for (int row = 0; row < m; row++) {
      for (int e = rows.start[row]; e < rows.start[row + 1]; e++) {
        columns[rows.column[e]].set(n + row);
        columns[n + row].set(rows.column[e]);
      }
    }
    return Arrays.stream(columns).map(rowsOf -> rowsOf.stream().toArray()).toArray(int[][]::new);
  }

  /**
   * Factors the equations of the corrections, with J as it has been written.
   *
   * @param a A; not modified
   * @param penalty α of a row of unit length
   * @return a negative number, or the unknown without a pivot
   */
  public int factor(TreeSquare a, double penalty) {
    setPenalties(penalty);
    factored.copy(a);
    size = Double.MIN_NORMAL;
    for (int place = 0; place < n; place++) {
      double unit = units[pattern.velocityAt[place]];
      size = Math.max(size, Math.abs(a.diagonal[place]) * unit * unit);
    }
    for (int place = 0; place < n; place++) {
      double unit = units[pattern.velocityAt[place]] / size;
      matrix[diagonal[place]] = a.diagonal[place] * unit * units[pattern.velocityAt[place]];
      for (int e = pattern.rowStart[place]; e < pattern.rowStart[place + 1]; e++) {
        double both = unit * units[pattern.velocityAt[pattern.column[e]]];
        matrix[lower[e]] = a.lower[e] * both;
        matrix[upper[e]] = a.upper[e] * both;
      }
    }
    for (int row = 0; row < m; row++) {
      matrix[ofPenalty[row]] = -size / penalties[row];
      for (int e = rows.start[row]; e < rows.start[row + 1]; e++) {
        double element = rows.value[e] * units[rows.column[e]];
        matrix[ofRow[e]] = element;
        matrix[ofColumn[e]] = element;
      }
    }
    return Math.min(lu.factor(matrix), n - 1);
  }

  @Override
  void correct(double[] force, double[] gap) {
    for (int i = 0; i < n; i++) {
      both[i] = units[i] * force[i] / size;
    }
    for (int row = 0; row < m; row++) {
      both[n + row] = -gap[row];
    }
    lu.solve(both);
    for (int i = 0; i < n; i++) {
      force[i] = units[i] * both[i];
    }
    for (int row = 0; row < m; row++) {
      gap[row] = size * both[n + row];
    }
  }

  @Override
  void subtractProduct(double[] x, int at, double[] force) {
    factored.addProduct(-1, x, at, force, 0);
  }
}
