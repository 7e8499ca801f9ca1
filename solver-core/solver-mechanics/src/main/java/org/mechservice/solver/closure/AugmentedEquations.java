package org.mechservice.solver.closure;

import java.util.Arrays;
import org.mechservice.solver.linear.Cholesky;
import org.mechservice.solver.linear.DenseLu;

/**
 * Solves A x + Jᵀ λ = r, J x + c = 0 by the augmented Lagrangian method, which iterates with the
 * factors of A + α JᵀJ. J may have redundant rows; their multipliers are then those of least norm.
 *
 * <p>Rows of J are divided by the sizes of what they measure. Every iteration starts from the
 * residuals of both equations and so recovers the digits that the penalty loses. Workspace of one
 * thread.
 */
public final class AugmentedEquations {
  private static final int REPETITIONS = 10;

  /** Relative residual at which the iteration stops. */
  private static final double ACCURATE = 1e-11;

  /** Reduction of the residual above which the iteration stops. */
  private static final double GAIN = 0.1;

  /** How the matrix A + α JᵀJ is factored and solved with. */
  public interface Factors {
    /** Factors a matrix; returns a negative number, or the row without a pivot. */
    int factor(double[] matrix);

    void solve(double[] b);

    /** Returns factors of a symmetric positive definite matrix. */
    static Factors of(Cholesky factors) {
      return new Factors() {
        @Override
        public int factor(double[] matrix) {
          return factors.factor(matrix);
        }

        @Override
        public void solve(double[] b) {
          factors.solve(b, 0);
        }
      };
    }

    /** Returns factors of an unsymmetric matrix. */
    static Factors of(DenseLu factors) {
      return new Factors() {
        @Override
        public int factor(double[] matrix) {
          return factors.factor(matrix);
        }

        @Override
        public void solve(double[] b) {
          factors.solve(b);
        }
      };
    }
  }

  private final Factors factors;
  private final int n;
  private final int m;

  /** J with its rows divided by their sizes, m × n; A, and A + α JᵀJ, n × n. */
  private final double[] rows;

  private final double[] matrix;
  private final double[] augmented;

  /** Units of the unknowns, 1/s, and α of each row. */
  private final double[] units;

  private final double[] penalties;

  private final double[] force;
  private final double[] gap;

  /** λ of the last solution, one per scaled row. */
  public final double[] multipliers;

  /**
   * @param units of the unknowns, which scale the columns of J
   */
  public AugmentedEquations(int equations, double[] units, Factors factors) {
    this.factors = factors;
    this.units = units;
    n = units.length;
    m = equations;
    penalties = new double[m];
    rows = new double[m * n];
    matrix = new double[n * n];
    augmented = new double[n * n];
    force = new double[n];
    gap = new double[m];
    multipliers = new double[m];
  }

  /**
   * Factors A + α JᵀJ.
   *
   * @param a A, n × n; not modified
   * @param scaledRows J, rows divided by their sizes, m × n; not modified
   * @param penalty α of a row of unit length. Longer rows get a smaller α, so that α JᵀJ does not
   *     swamp A; the rows of a ring of many bodies are as long as the ring is wide
   * @return a negative number, or the unknown without a pivot
   */
  public int factor(double[] a, double[] scaledRows, double penalty) {
    System.arraycopy(a, 0, matrix, 0, n * n);
    System.arraycopy(a, 0, augmented, 0, n * n);
    System.arraycopy(scaledRows, 0, rows, 0, m * n);
    for (int row = 0; row < m; row++) {
      penalties[row] = penalty / Math.max(1, square(row));
      addSquare(row);
    }
    return factors.factor(augmented);
  }

  private double square(int row) {
    double sum = 0;
    for (int j = 0; j < n; j++) {
      double part = rows[row * n + j] * units[j];
      sum += part * part;
    }
    return sum;
  }

  private void addSquare(int row) {
    for (int i = 0; i < n; i++) {
      double weighted = penalties[row] * rows[row * n + i];
      for (int j = 0; weighted != 0 && j < n; j++) {
        augmented[i * n + j] += weighted * rows[row * n + j];
      }
    }
  }

  /**
   * Solves with the last factors.
   *
   * @param right r; not modified
   * @param offset c, rows divided by their sizes; not modified
   * @param x from {@code at}; overwritten
   */
  public void solve(double[] right, double[] offset, double[] x, int at) {
    Arrays.fill(x, at, at + n, 0);
    Arrays.fill(multipliers, 0);
    System.arraycopy(right, 0, force, 0, n);
    System.arraycopy(offset, 0, gap, 0, m);
    double open = Double.POSITIVE_INFINITY;
    for (int i = 0; i < REPETITIONS; i++) {
      correct(x, at);
      double scale = residuals(right, offset, x, at);
      double left = largest(gap);
      if (i > 0 && (!(left > ACCURATE * scale) || !(left < GAIN * open))) {
        return;
      }
      open = left;
    }
  }

  /** x += (A + α JᵀJ)⁻¹ (f − α Jᵀ g), λ += α (g + J Δx). */
  private void correct(double[] x, int at) {
    for (int row = 0; row < m; row++) {
      double push = penalties[row] * gap[row];
      for (int j = 0; push != 0 && j < n; j++) {
        force[j] -= push * rows[row * n + j];
      }
    }
    factors.solve(force);
    for (int row = 0; row < m; row++) {
      multipliers[row] += penalties[row] * (gap[row] + product(row, force, 0));
    }
    for (int j = 0; j < n; j++) {
      x[at + j] += force[j];
    }
  }

  /** f = r − A x − Jᵀ λ, g = c + J x; returns the size of what g is the difference of. */
  private double residuals(double[] right, double[] offset, double[] x, int at) {
    for (int i = 0; i < n; i++) {
      double sum = right[i];
      for (int j = 0; j < n; j++) {
        sum -= matrix[i * n + j] * x[at + j];
      }
      force[i] = sum;
    }
    double scale = 0;
    for (int row = 0; row < m; row++) {
      double moved = product(row, x, at);
      gap[row] = offset[row] + moved;
      scale = Math.max(scale, Math.max(Math.abs(offset[row]), Math.abs(moved)));
      for (int j = 0; j < n; j++) {
        force[j] -= multipliers[row] * rows[row * n + j];
      }
    }
    return scale;
  }

  private double product(int row, double[] x, int at) {
    double sum = 0;
    for (int j = 0; j < n; j++) {
      sum += rows[row * n + j] * x[at + j];
    }
    return sum;
  }

  private static double largest(double[] x) {
    double largest = 0;
    for (double element : x) {
      largest = Math.max(largest, Math.abs(element));
    }
    return largest;
  }
}
