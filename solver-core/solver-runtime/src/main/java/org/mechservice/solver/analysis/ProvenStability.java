package org.mechservice.solver.analysis;

import java.util.Random;
import org.mechservice.solver.analysis.equation.Linearisation;
import org.mechservice.solver.linear.Cholesky;

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
  /** Elements that differ from those across by less than this part of the largest are symmetric. */
  private static final double SYMMETRIC = 1e-9;

  /** Steps of a power iteration from a random vector, and a bound of what it falls short by. */
  private static final int STEPS = 40;

  private static final double SHORT = 4;

  private final int f;
  private final double[] mass;
  private final double[] damping;
  private final double[] stiffness;
  private final Cholesky ofMass;
  private final Cholesky ofStiffness;

  private ProvenStability(Linearisation linear) {
    f = linear.freedom();
    mass = linear.mass;
    damping = linear.damping;
    stiffness = linear.stiffness;
    ofMass = new Cholesky(f);
    ofStiffness = new Cholesky(f);
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
    return secondOrder && new ProvenStability(linear).proves(zero);
  }

  private boolean proves(double zero) {
    if (!isSymmetric(mass)
        || !isSymmetric(stiffness)
        || !isSymmetric(damping)
        || ofStiffness.factor(stiffness) != Cholesky.POSITIVE_DEFINITE
        || ofMass.factor(mass) != Cholesky.POSITIVE_DEFINITE) {
      return false;
    }
    double fastest = Math.sqrt(largest(stiffness, ofMass));
    double slowest = 1 / Math.sqrt(largest(mass, ofStiffness));
    double a = 0;
    double b = 0;
    if (isDamped()) {
      if (!isNotNegative()) {
        return false;
      }
      a = largest(damping, ofMass);
      b = largest(damping, ofStiffness);
    }
    return SHORT * (b + 1 / slowest) * SHORT * (a + fastest) * zero < 1;
  }

  private boolean isSymmetric(double[] matrix) {
    double largest = 0;
    double across = 0;
    for (int i = 0; i < f; i++) {
      for (int j = 0; j <= i; j++) {
        largest = Math.max(largest, Math.abs(matrix[i * f + j]));
        across = Math.max(across, Math.abs(matrix[i * f + j] - matrix[j * f + i]));
      }
    }
    return across <= SYMMETRIC * largest;
  }

  private boolean isDamped() {
    for (double element : damping) {
      if (element != 0) {
        return true;
      }
    }
    return false;
  }

  /** Returns whether C is not negative, up to what {@link #SYMMETRIC} calls rounding. */
  private boolean isNotNegative() {
    double part = SYMMETRIC * largest(damping, ofMass);
    double[] raised = damping.clone();
    for (int i = 0; i < raised.length; i++) {
      raised[i] += part * mass[i];
    }
    return new Cholesky(f).factor(raised) == Cholesky.POSITIVE_DEFINITE;
  }

  /** Returns about the largest eigenvalue of A x = μ B x by a power iteration, from below. */
  private double largest(double[] a, Cholesky b) {
    double[] x = new Random(271828).doubles(f, -1, 1).toArray();
    double growth = 0;
    for (int step = 0; step < STEPS; step++) {
      double[] next = new double[f];
      double length = 0;
      for (int i = 0; i < f; i++) {
        length = Math.hypot(length, x[i]);
      }
      for (int i = 0; i < f && length > 0; i++) {
        double sum = 0;
        for (int j = 0; j < f; j++) {
          sum += a[i * f + j] * x[j];
        }
        next[i] = sum / length;
      }
      b.solve(next, 0);
      growth = 0;
      for (int i = 0; i < f; i++) {
        growth = Math.hypot(growth, next[i]);
      }
      x = next;
    }
    return growth;
  }
}
