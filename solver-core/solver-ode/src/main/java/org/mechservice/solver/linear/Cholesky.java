package org.mechservice.solver.linear;

/**
 * Factors A = L Lᵀ of a dense symmetric positive definite matrix. Golub and Van Loan, algorithm
 * 4.2.1.
 *
 * <p>A workspace for one thread; its methods allocate nothing.
 */
public final class Cholesky {
  /** Result of {@link #factor} if the matrix is positive definite. */
  public static final int POSITIVE_DEFINITE = -1;

  /** A pivot below this part of its diagonal element is rounding. */
  private static final double SINGULAR = 64 * Math.ulp(1.0);

  private final int n;

  /** L in the lower triangle, row after row, length n². */
  private final double[] l;

  private double smallestPivot;

  /**
   * @param dimension n, not negative
   */
  public Cholesky(int dimension) {
    n = dimension;
    l = new double[n * n];
  }

  /**
   * Factors a matrix; what was factored before is forgotten.
   *
   * @param matrix n × n row after row, at least n² numbers; only the lower triangle is read; not
   *     modified
   * @return {@link #POSITIVE_DEFINITE}, or the first row, from 0, whose pivot is not larger than
   *     the rounding of its diagonal element
   */
  public int factor(double[] matrix) {
    smallestPivot = 1;
    for (int i = 0; i < n; i++) {
      for (int j = 0; j <= i; j++) {
        double sum = matrix[i * n + j];
        for (int k = 0; k < j; k++) {
          sum -= l[i * n + k] * l[j * n + k];
        }
        if (j < i) {
          l[i * n + j] = sum / l[j * n + j];
        } else if (!acceptPivot(i, sum, matrix[i * n + i])) {
          return i;
        }
      }
    }
    return POSITIVE_DEFINITE;
  }

  private boolean acceptPivot(int i, double pivot, double diagonal) {
    if (!(pivot > SINGULAR * diagonal) || !Double.isFinite(pivot)) {
      return false;
    }
    smallestPivot = Math.min(smallestPivot, pivot / diagonal);
    l[i * n + i] = Math.sqrt(pivot);
    return true;
  }

  /**
   * Returns the smallest ratio of a pivot to its diagonal element in the last {@link #factor},
   * between 0 and 1; a measure of singularity that does not depend on units.
   */
  public double smallestPivot() {
    return smallestPivot;
  }

  /** Solves A x = b; {@code b} from {@code at}, overwritten with x. */
  public void solve(double[] b, int at) {
    solveLower(b, at);
    solveUpper(b, at);
  }

  /** Solves L x = b in place. */
  public void solveLower(double[] b, int at) {
    for (int i = 0; i < n; i++) {
      double sum = b[at + i];
      for (int k = 0; k < i; k++) {
        sum -= l[i * n + k] * b[at + k];
      }
      b[at + i] = sum / l[i * n + i];
    }
  }

  /** Solves Lᵀ x = b in place. */
  public void solveUpper(double[] b, int at) {
    for (int i = n - 1; i >= 0; i--) {
      double sum = b[at + i];
      for (int k = i + 1; k < n; k++) {
        sum -= l[k * n + i] * b[at + k];
      }
      b[at + i] = sum / l[i * n + i];
    }
  }
}
