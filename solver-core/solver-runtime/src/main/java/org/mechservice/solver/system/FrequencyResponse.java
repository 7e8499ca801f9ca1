package org.mechservice.solver.system;

import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;

/**
 * The frequency response G(iω) = C (iω − A)⁻¹ B + D of a linear system. The complex equations are
 * solved as real ones of twice the size; one frequency costs O(n³).
 */
public final class FrequencyResponse {
  private final LinearSystem system;
  private final int n;
  private final int m;
  private final int p;
  private final double[] matrix;
  private final double[] right;
  private final DenseLu lu;

  /** Re G and Im G, outputs × inputs. */
  private final double[] re;

  private final double[] im;

  /** Prepares the response of a system. */
  public FrequencyResponse(LinearSystem system) {
    this.system = system;
    n = system.states().size();
    m = system.inputs().size();
    p = system.outputs().size();
    matrix = new double[4 * n * n];
    right = new double[2 * n];
    lu = new DenseLu(2 * n);
    re = new double[p * m];
    im = new double[p * m];
  }

  /**
   * Evaluates G(iω).
   *
   * @param omega ω, rad/s
   * @return false if iω is an eigenvalue of A to rounding, so that the response is not finite
   */
  public boolean evaluate(double omega) {
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        matrix[i * 2 * n + j] = -system.a(i, j);
        matrix[i * 2 * n + n + j] = i == j ? -omega : 0;
        matrix[(n + i) * 2 * n + j] = i == j ? omega : 0;
        matrix[(n + i) * 2 * n + n + j] = -system.a(i, j);
      }
    }
    if (n > 0 && lu.factor(matrix) != LinearSolver.NONSINGULAR) {
      return false;
    }
    for (int k = 0; k < m; k++) {
      for (int i = 0; i < n; i++) {
        right[i] = system.b(i, k);
        right[n + i] = 0;
      }
      lu.solve(right);
      for (int l = 0; l < p; l++) {
        double real = system.d(l, k);
        double imaginary = 0;
        for (int i = 0; i < n; i++) {
          real += system.c(l, i) * right[i];
          imaginary += system.c(l, i) * right[n + i];
        }
        re[l * m + k] = real;
        im[l * m + k] = imaginary;
      }
    }
    return true;
  }

  /** Returns |G| from an input to an output at the last frequency. */
  public double gain(int output, int input) {
    return StrictMath.hypot(re[output * m + input], im[output * m + input]);
  }

  /** Returns the argument of G, rad, above −π and up to π. */
  public double phase(int output, int input) {
    return StrictMath.atan2(im[output * m + input], re[output * m + input]);
  }
}
