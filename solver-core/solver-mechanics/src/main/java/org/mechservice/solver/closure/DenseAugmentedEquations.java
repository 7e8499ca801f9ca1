package org.mechservice.solver.closure;

import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.linear.Cholesky;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * Corrections by dense factors of A + α JᵀJ, which is fast for small mechanisms. Workspace of one
 * thread.
 */
public final class DenseAugmentedEquations extends AugmentedEquations {
  /** Factors of the matrix A + α JᵀJ. */
  private interface Factors {
    /** Factors a matrix; returns a negative number, or the row without a pivot. */
    int factor(double[] matrix);

    void solve(double[] b);
  }

  private final Factors factors;

  /** A, and A + α JᵀJ, n × n. */
  private final double[] matrix;

  private final double[] augmented;

  private DenseAugmentedEquations(SparseMatrix rows, double[] units, Factors factors) {
    super(rows, units);
    this.factors = factors;
    matrix = new double[n * n];
    augmented = new double[n * n];
  }

  /**
   * Returns equations with a symmetric positive definite A.
   *
   * @param rows J, to be written before each factorisation
   * @param units of the unknowns, which scale the columns of J
   */
  static DenseAugmentedEquations symmetric(SparseMatrix rows, double[] units) {
    Cholesky cholesky = new Cholesky(units.length);
    return new DenseAugmentedEquations(
        rows,
        units,
        new Factors() {
          @Override
          public int factor(double[] matrix) {
            return cholesky.factor(matrix);
          }

          @Override
          public void solve(double[] b) {
            cholesky.solve(b, 0);
          }
        });
  }

  /**
   * Returns equations with any A.
   *
   * @param rows J, to be written before each factorisation
   * @param units of the unknowns, which scale the columns of J
   */
  public static DenseAugmentedEquations general(SparseMatrix rows, double[] units) {
    DenseLu lu = new DenseLu(units.length);
    return new DenseAugmentedEquations(
        rows,
        units,
        new Factors() {
          @Override
          public int factor(double[] matrix) {
            return lu.factor(matrix);
          }

          @Override
          public void solve(double[] b) {
            lu.solve(b);
          }
        });
  }

  /**
   * Factors the equations of the corrections, with J as it has been written.
   *
   * @param a A; not modified
   * @param penalty α of a row of unit length
   * @return a negative number, or the unknown without a pivot
   */
  public int factor(TreeSquare a, double penalty) {
    a.toDense(matrix);
    return factorAugmented(penalty);
  }

  /**
   * Factors as {@link #factor(TreeSquare, double)}.
   *
   * @param a A, n × n; not modified
   */
  int factor(double[] a, double penalty) {
    System.arraycopy(a, 0, matrix, 0, n * n);
    return factorAugmented(penalty);
  }

  private int factorAugmented(double penalty) {
    setPenalties(penalty);
    System.arraycopy(matrix, 0, augmented, 0, n * n);
    for (int row = 0; row < m; row++) {
      for (int e = rows.start[row]; e < rows.start[row + 1]; e++) {
        double weighted = penalties[row] * rows.value[e];
        if (weighted != 0) {
          rows.addRow(row, weighted, augmented, n * rows.column[e]);
        }
      }
    }
    return factors.factor(augmented);
  }

  /** Δx = (A + α JᵀJ)⁻¹ (f − α Jᵀ g), Δλ = α (g + J Δx). */
  @Override
  void correct(double[] force, double[] gap) {
    for (int row = 0; row < m; row++) {
      double push = penalties[row] * gap[row];
      if (push != 0) {
        rows.addRow(row, -push, force, 0);
      }
    }
    factors.solve(force);
    for (int row = 0; row < m; row++) {
      gap[row] = penalties[row] * (gap[row] + rows.product(row, force, 0));
    }
  }

  @Override
  void subtractProduct(double[] x, int at, double[] force) {
    for (int i = 0; i < n; i++) {
      double sum = force[i];
      for (int j = 0; j < n; j++) {
        sum -= matrix[i * n + j] * x[at + j];
      }
      force[i] = sum;
    }
  }
}
