package org.mechservice.solver.analysis;

import java.util.Random;
import org.mechservice.solver.analysis.equation.Linearisation;

/**
 * A proof that an equilibrium is stable and isolated, without eigenvalues of the first-order
 * system: these take some 80 f³ operations for f freedoms, the proof two Cholesky factors.
 *
 * <p>With symmetric M and K, both positive definite, and C symmetric and not negative, energy only
 * falls, and each eigenvalue λ of λ² M + λ C + K has a real part that is not positive. With m =
 * x*Mx, c = x*Cx and k = x*Kx of its vector, |λ| ≤ c/m + √(k/m) and 1/|λ| ≤ c/k + √(m/k). So with
 * the largest eigenvalues a of M⁻¹C, ω² of M⁻¹K, b of K⁻¹C and 1/ω₀² of K⁻¹M, all |λ| lie between
 * 1/(b + 1/ω₀) and a + ω. No mode counts as one without restoring force if these are closer than
 * that rule asks. Where the proof fails, nothing is said, and the eigenvalues decide.
 */
final class ProvenStability {
  /** Part of M that makes C positive definite if it is not negative but for rounding. */
  private static final double ROUNDING = 1e-9;

  /** Steps of a power iteration from a random vector, and a bound of what it falls short by. */
  private static final int STEPS = 40;

  private static final double SHORT = 4;

  private final MotionForms forms;

  private ProvenStability(MotionForms forms) {
    this.forms = forms;
  }

  /**
   * Returns whether all modes are proven to be stable and to have a restoring force.
   *
   * @param zero part of the largest eigenvalue below which one counts as zero
   */
  static boolean of(Linearisation linear, double zero) {
    boolean secondOrder =
        linear.freedom() > 0
            && linear.placeFreedom() == linear.freedom()
            && linear.furtherCount() == 0;
    return secondOrder && of(MotionForms.of(linear), zero);
  }

  /** As {@link #of(Linearisation, double)}, for motions of second order. */
  static boolean of(MotionForms forms, double zero) {
    return new ProvenStability(forms).proves(zero);
  }

  private boolean proves(double zero) {
    if (!forms.isSymmetric() || !forms.factor(0, 0, 1)) {
      return false;
    }
    boolean damped = forms.isDamped();
    double perSlowest = Math.sqrt(largest(forms, 1, 0, 0));
    double b = damped ? largest(forms, 0, 1, 0) : 0;
    if (!forms.factor(1, 0, 0)) {
      return false;
    }
    double fastest = Math.sqrt(largest(forms, 0, 0, 1));
    double a = damped ? largest(forms, 0, 1, 0) : 0;
    return (!damped || isNotNegative(forms, a))
        && SHORT * (b + perSlowest) * SHORT * (a + fastest) * zero < 1;
  }

  /**
   * Returns whether C is not negative, up to rounding; its factors take the place of the last ones.
   *
   * @param largest eigenvalue of M⁻¹C
   */
  static boolean isNotNegative(MotionForms forms, double largest) {
    return forms.factor(ROUNDING * largest, 1, 0);
  }

  /**
   * Returns about the largest eigenvalue of A x = μ B x, with B factored last, by a power iteration
   * from below.
   */
  static double largest(MotionForms forms, double mass, double damping, double stiffness) {
    double[] x = new Random(271828).doubles(forms.size(), -1, 1).toArray();
    forms.solve(x);
    double[] next = new double[x.length];
    double growth = 0;
    for (int step = 0; step < STEPS; step++) {
      double length = norm(x);
      for (int i = 0; i < x.length && length > 0; i++) {
        x[i] /= length;
      }
      forms.multiply(mass, damping, stiffness, x, next);
      forms.solve(next);
      growth = norm(next);
      System.arraycopy(next, 0, x, 0, x.length);
    }
    return growth;
  }

  private static double norm(double[] x) {
    double largest = 0;
    for (double element : x) {
      largest = Math.max(largest, Math.abs(element));
    }
    double sum = 0;
    for (double element : x) {
      sum += largest > 0 ? element / largest * (element / largest) : 0;
    }
    return largest * Math.sqrt(sum);
  }
}
