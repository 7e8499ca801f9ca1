package org.mechservice.solver.closure;

import java.util.Arrays;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * Solves A x + Jᵀ λ = r, J x + c = 0 by the augmented Lagrangian method, whose corrections are
 *
 * <pre>A Δx + Jᵀ Δλ = f,   J Δx − Δλ / α = −g</pre>
 *
 * <p>with the residuals f and g of both equations. J may have redundant rows; their multipliers are
 * then those of least norm. Every correction starts from the residuals and so recovers the digits
 * that the penalty α loses. Rows of J are divided by the sizes of what they measure. Workspace of
 * one thread.
 */
public abstract sealed class AugmentedEquations
    permits ArticulatedAugmentedEquations,
        DenseAugmentedEquations,
        LinkedAugmentedEquations,
        SparseAugmentedEquations {
  private static final int REPETITIONS = 10;

  /** Relative residual at which the iteration stops. */
  private static final double ACCURATE = 1e-11;

  /** Reduction of the residual above which the iteration stops. */
  private static final double GAIN = 0.1;

  final int n;
  final int m;

  /** J with its rows divided by their sizes, m × n; the caller writes its elements. */
  final SparseMatrix rows;

  /** Units of the unknowns, 1/s, and α of each row. */
  final double[] units;

  final double[] penalties;

  private final double[] force;
  private final double[] gap;

  /** λ of the last solution, one per scaled row. */
  public final double[] multipliers;

  /**
   * @param rows J, to be written before each factorisation
   * @param units of the unknowns, which scale the columns of J
   */
  AugmentedEquations(SparseMatrix rows, double[] units) {
    this.rows = rows;
    this.units = units;
    n = units.length;
    m = rows.rows();
    penalties = new double[m];
    force = new double[n];
    gap = new double[m];
    multipliers = new double[m];
  }

  /** Takes up J as it has been written, with the loops placed at its state. */
  public void linearise() {}

  /**
   * Solves for one correction.
   *
   * @param force f; overwritten with Δx
   * @param gap g; overwritten with Δλ
   */
  abstract void correct(double[] force, double[] gap);

  /** Subtracts A x, the x from {@code at}, from a force. */
  abstract void subtractProduct(double[] x, int at, double[] force);

  /**
   * Sets α of each row.
   *
   * @param penalty α of a row of unit length. Longer rows get a smaller α, so that α JᵀJ does not
   *     swamp A; the rows of a ring of many bodies are as long as the ring is wide
   */
  final void setPenalties(double penalty) {
    for (int row = 0; row < m; row++) {
      penalties[row] = penalty / Math.max(1, square(row));
    }
  }

  private double square(int row) {
    double sum = 0;
    for (int e = rows.start[row]; e < rows.start[row + 1]; e++) {
      double part = rows.value[e] * units[rows.column[e]];
      sum += part * part;
    }
    return sum;
  }

  /**
   * Solves with the last factors.
   *
   * @param right r; not modified
   * @param offset c, rows divided by their sizes; not modified
   * @param x from {@code at}; overwritten
   */
  public final void solve(double[] right, double[] offset, double[] x, int at) {
    Arrays.fill(x, at, at + n, 0);
    Arrays.fill(multipliers, 0);
    System.arraycopy(right, 0, force, 0, n);
    System.arraycopy(offset, 0, gap, 0, m);
    double open = Double.POSITIVE_INFINITY;
    for (int i = 0; i < REPETITIONS; i++) {
      correct(force, gap);
      for (int row = 0; row < m; row++) {
        multipliers[row] += gap[row];
      }
      for (int j = 0; j < n; j++) {
        x[at + j] += force[j];
      }
      double scale = residuals(right, offset, x, at);
      double left = largest(gap);
      if (i > 0 && (!(left > ACCURATE * scale) || !(left < GAIN * open))) {
        return;
      }
      open = left;
    }
  }

  /** f = r − A x − Jᵀ λ, g = c + J x; returns the size of what g is the difference of. */
  private double residuals(double[] right, double[] offset, double[] x, int at) {
    System.arraycopy(right, 0, force, 0, n);
    subtractProduct(x, at, force);
    double scale = 0;
    for (int row = 0; row < m; row++) {
      double moved = rows.product(row, x, at);
      gap[row] = offset[row] + moved;
      scale = Math.max(scale, Math.max(Math.abs(offset[row]), Math.abs(moved)));
      rows.addRow(row, -multipliers[row], force, 0);
    }
    return scale;
  }

  private static double largest(double[] x) {
    double largest = 0;
    for (double element : x) {
      largest = Math.max(largest, Math.abs(element));
    }
    return largest;
  }
}
