package org.mechservice.solver.linear;

import java.util.Arrays;

/**
 * Estimates the largest row sum of |A⁻¹| from a few solutions with A and Aᵀ.
 *
 * <p>It is the largest of ‖A⁻ᵀ x‖₁ over ‖x‖₁ = 1, a convex function, so climbed along its gradient
 * from corner to corner of that set; a last try with a vector of alternating signs catches matrices
 * on which the climb is deceived. Hager 1984; Higham 1988, ACM TOMS 14:381.
 */
final class InverseNorm {
  private static final int CORNERS_TRIED = 4;

  private final double[] x;
  private final double[] gradient;

  InverseNorm(int dimension) {
    x = new double[dimension];
    gradient = new double[dimension];
  }

  /** Returns the estimate, a lower bound, for factors of dimension 1 or more. */
  double of(LuFactors factors) {
    int n = x.length;
    Arrays.fill(x, 1.0 / n);
    factors.substituteTransposed(x);
    double estimate = sum(x);
    int corner = -1;
    for (int i = 0; i < CORNERS_TRIED; i++) {
      climb(factors);
      int steepest = largest(gradient);
      if (steepest == corner) {
        break;
      }
      corner = steepest;
      Arrays.fill(x, 0);
      x[corner] = 1;
      factors.substituteTransposed(x);
      double reached = sum(x);
      if (!(reached > estimate)) {
        break;
      }
      estimate = reached;
    }
    return Math.max(estimate, ofAlternatingSigns(factors));
  }

  /** Gradient of ‖A⁻ᵀ x‖₁: A⁻¹ times the signs of A⁻ᵀ x. */
  private void climb(LuFactors factors) {
    for (int i = 0; i < x.length; i++) {
      gradient[i] = Math.copySign(1, x[i]);
    }
    factors.substitute(gradient);
  }

  private double ofAlternatingSigns(LuFactors factors) {
    int n = x.length;
    for (int i = 0; i < n; i++) {
      double size = 1 + (double) i / Math.max(1, n - 1);
      x[i] = i % 2 == 0 ? size : -size;
    }
    factors.substituteTransposed(x);
    return 2 * sum(x) / (3 * n);
  }

  private static double sum(double[] x) {
    double sum = 0;
    for (double part : x) {
      sum += Math.abs(part);
    }
    return sum;
  }

  private static int largest(double[] x) {
    int largest = 0;
    for (int i = 1; i < x.length; i++) {
      if (Math.abs(x[i]) > Math.abs(x[largest])) {
        largest = i;
      }
    }
    return largest;
  }
}
