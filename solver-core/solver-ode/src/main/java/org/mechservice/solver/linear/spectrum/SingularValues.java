package org.mechservice.solver.linear.spectrum;

import java.util.Arrays;
import org.mechservice.solver.linear.Interruption;

/**
 * Singular values A = U Σ Vᵀ of a small m × n matrix by one-sided Jacobi rotations: the rows are
 * turned against each other until they are orthogonal. Small singular values come out to a few
 * units of round-off of the largest, of a matrix with scaled rows even relatively. Hestenes 1958;
 * Demmel and Veselić, SIAM J. Matrix Anal. Appl. 13 (1992) 1204.
 *
 * <p>A workspace for one thread; its methods allocate nothing.
 */
public final class SingularValues {
  private static final int SWEEPS = 60;
  private static final double ORTHOGONAL = 4 * Math.ulp(1.0);

  private final int m;
  private final int n;

  /** Rows Uᵀ A = Σ Vᵀ, m × n. */
  private final double[] b;

  /** Uᵀ, m × m, row k belongs to singular value k. */
  private final double[] u;

  private final double[] sigma;
  private final double[] coefficient;

  /**
   * @param rows m, not negative
   * @param columns n, not negative
   */
  public SingularValues(int rows, int columns) {
    m = rows;
    n = columns;
    b = new double[m * n];
    u = new double[m * m];
    sigma = new double[m];
    coefficient = new double[m];
  }

  /**
   * Decomposes a matrix.
   *
   * @param matrix m × n row after row, at least m n numbers, finite; not modified
   */
  public void decompose(double[] matrix) {
    System.arraycopy(matrix, 0, b, 0, m * n);
    Arrays.fill(u, 0);
    for (int i = 0; i < m; i++) {
      u[i * m + i] = 1;
    }
    boolean turned = true;
    for (int sweep = 0; turned && sweep < SWEEPS; sweep++) {
      turned = sweep();
    }
    sort();
  }

  private boolean sweep() {
    boolean turned = false;
    for (int i = 0; i < m; i++) {
      Interruption.check();
      for (int j = i + 1; j < m; j++) {
        turned |= makeOrthogonal(i, j);
      }
    }
    return turned;
  }

  private boolean makeOrthogonal(int i, int j) {
    double ii = dot(i, i);
    double jj = dot(j, j);
    double ij = dot(i, j);
    if (!(Math.abs(ij) > ORTHOGONAL * Math.sqrt(ii) * Math.sqrt(jj))) {
      return false;
    }
    double zeta = (jj - ii) / (2 * ij);
    double t = Math.copySign(1, zeta) / (Math.abs(zeta) + Math.sqrt(1 + zeta * zeta));
    double cos = 1 / Math.sqrt(1 + t * t);
    turn(b, n, i, j, cos, cos * t);
    turn(u, m, i, j, cos, cos * t);
    return true;
  }

  private double dot(int i, int j) {
    double sum = 0;
    for (int k = 0; k < n; k++) {
      sum += b[i * n + k] * b[j * n + k];
    }
    return sum;
  }

  private static void turn(double[] a, int width, int i, int j, double cos, double sin) {
    for (int k = 0; k < width; k++) {
      double ai = a[i * width + k];
      double aj = a[j * width + k];
      a[i * width + k] = cos * ai - sin * aj;
      a[j * width + k] = sin * ai + cos * aj;
    }
  }

  /** Largest first. */
  private void sort() {
    for (int i = 0; i < m; i++) {
      sigma[i] = Math.sqrt(dot(i, i));
    }
    for (int i = 0; i < m; i++) {
      int largest = i;
      for (int j = i + 1; j < m; j++) {
        if (sigma[j] > sigma[largest]) {
          largest = j;
        }
      }
      swap(i, largest);
    }
  }

  private void swap(int i, int j) {
    double s = sigma[i];
    sigma[i] = sigma[j];
    sigma[j] = s;
    swapRows(b, n, i, j);
    swapRows(u, m, i, j);
  }

  private static void swapRows(double[] a, int width, int i, int j) {
    for (int k = 0; i != j && k < width; k++) {
      double element = a[i * width + k];
      a[i * width + k] = a[j * width + k];
      a[j * width + k] = element;
    }
  }

  /** Returns singular value k, 0 ≤ k &lt; m, the largest first; those beyond n are 0. */
  public double value(int k) {
    return sigma[k];
  }

  /**
   * Returns the rank by the widest gap: r such that σ_r / σ_{r+1} exceeds {@code gap} and what lies
   * beyond is below {@code negligible} of the largest; min(m, n) if there is no such gap.
   *
   * @param gap ratio that counts as a gap, above 1
   * @param negligible part of the largest singular value, below 1
   */
  public int rank(double gap, double negligible) {
    int full = Math.min(m, n);
    if (full == 0 || !(sigma[0] > 0)) {
      return 0;
    }
    for (int r = 1; r < full; r++) {
      if (sigma[r] <= negligible * sigma[0] && sigma[r] * gap <= sigma[r - 1]) {
        return r;
      }
    }
    return full;
  }

  /**
   * Solves A x ≈ b with the least error and, among those, the smallest x, by the {@code rank}
   * largest singular values.
   *
   * @param right right-hand side, m numbers; not modified
   * @param x n numbers; overwritten
   */
  public void solve(int rank, double[] right, double[] x) {
    Arrays.fill(x, 0, n, 0);
    for (int k = 0; k < rank; k++) {
      double projected = 0;
      for (int i = 0; i < m; i++) {
        projected += u[k * m + i] * right[i];
      }
      coefficient[k] = projected / (sigma[k] * sigma[k]);
      for (int j = 0; j < n; j++) {
        x[j] += coefficient[k] * b[k * n + j];
      }
    }
  }

  /**
   * Solves (AᵀA + μ 1) x = Aᵀ b, a step of Levenberg and Marquardt.
   *
   * @param damping μ, positive
   * @param right right-hand side, m numbers; not modified
   * @param x n numbers; overwritten
   */
  public void solveDamped(double damping, double[] right, double[] x) {
    Arrays.fill(x, 0, n, 0);
    for (int k = 0; k < m; k++) {
      double projected = 0;
      for (int i = 0; i < m; i++) {
        projected += u[k * m + i] * right[i];
      }
      double part = projected / (sigma[k] * sigma[k] + damping);
      for (int j = 0; j < n; j++) {
        x[j] += part * b[k * n + j];
      }
    }
  }

  /**
   * Solves Aᵀ x ≈ b with the least error and, among those, the smallest x.
   *
   * @param right right-hand side, n numbers; not modified
   * @param x m numbers; overwritten
   */
  public void solveTransposed(int rank, double[] right, double[] x) {
    Arrays.fill(x, 0, m, 0);
    for (int k = 0; k < rank; k++) {
      double projected = 0;
      for (int j = 0; j < n; j++) {
        projected += b[k * n + j] * right[j];
      }
      coefficient[k] = projected / (sigma[k] * sigma[k]);
      for (int i = 0; i < m; i++) {
        x[i] += coefficient[k] * u[k * m + i];
      }
    }
  }
}
