package org.mechservice.solver.ode.backward;

import java.util.Arrays;

/**
 * Steps at which formulas of orders 3 to 5 make a damped oscillation grow: intervals of h |λ| for
 * y' = λ y, by the damping ratio −Re λ / |λ|. They begin and end with the points of the curve below
 * that have this ratio or more.
 *
 * <p>The values ζ^n of a solution obey the formula where h λ = Σ_{m=1..k} (1 − 1/ζ)^m / m − κ_k γ_k
 * (1 − 1/ζ)^{k+1}; for |ζ| = 1 that is the curve around the steps at which they grow. Hairer and
 * Wanner 1996, V.1; Shampine and Reichelt 1997, §2.
 */
final class UnstableSteps {
  private static final int LOWEST_ORDER = 3;

  /**
   * Damping ratios told apart, equally spaced in their square roots: the small ones more finely.
   */
  private static final int RATIOS = 300;

  /** Points on half of a curve. */
  private static final int POINTS = 720;

  /** Part of the plane around 0 that is left out: steps that resolve any oscillation. */
  private static final double RESOLVED = 0.1;

  /** Shortest and longest by order and damping ratio; none if the shortest is infinite. */
  private final double[][] shortest = new double[BackwardFormulas.HIGHEST_ORDER + 1][RATIOS + 1];

  private final double[][] longest = new double[BackwardFormulas.HIGHEST_ORDER + 1][RATIOS + 1];

  UnstableSteps(BackwardFormulas formulas) {
    for (int k = LOWEST_ORDER; k <= BackwardFormulas.HIGHEST_ORDER; k++) {
      Arrays.fill(shortest[k], Double.POSITIVE_INFINITY);
      for (int i = 0; i <= POINTS; i++) {
        place(formulas, k, Math.PI * i / POINTS);
      }
      for (int i = RATIOS - 1; i >= 0; i--) {
        shortest[k][i] = Math.min(shortest[k][i], shortest[k][i + 1]);
        longest[k][i] = Math.max(longest[k][i], longest[k][i + 1]);
      }
    }
  }

  /** Adds the point of the curve of order k with a direction of ζ. */
  private void place(BackwardFormulas formulas, int k, double direction) {
    double differenceReal = 1 - StrictMath.cos(direction);
    double differenceImaginary = StrictMath.sin(direction);
    double powerReal = 1;
    double powerImaginary = 0;
    double real = 0;
    double imaginary = 0;
    for (int m = 1; m <= k + 1; m++) {
      double next = powerReal * differenceReal - powerImaginary * differenceImaginary;
      powerImaginary = powerReal * differenceImaginary + powerImaginary * differenceReal;
      powerReal = next;
      double share = m <= k ? 1.0 / m : -formulas.kappa(k) * formulas.gamma(k);
      real += share * powerReal;
      imaginary += share * powerImaginary;
    }
    double size = Math.sqrt(real * real + imaginary * imaginary);
    if (real <= 0 && size > RESOLVED) {
      int ratio = place(-real / size);
      shortest[k][ratio] = Math.min(shortest[k][ratio], size);
      longest[k][ratio] = Math.max(longest[k][ratio], size);
    }
  }

  private static int place(double dampingRatio) {
    return (int) (Math.sqrt(dampingRatio) * RATIOS);
  }

  /**
   * Returns the first h |λ| from which on an oscillation grows; infinite if it never does.
   *
   * @param dampingRatio −Re λ / |λ|, 0 to 1
   */
  double first(int k, double dampingRatio) {
    return k < LOWEST_ORDER ? Double.POSITIVE_INFINITY : shortest[k][place(dampingRatio)];
  }

  /** Returns whether an oscillation grows at this h |λ|. */
  boolean contains(int k, double size, double dampingRatio) {
    if (k < LOWEST_ORDER) {
      return false;
    }
    int ratio = place(dampingRatio);
    return size > shortest[k][ratio] && size < longest[k][ratio];
  }
}
