package org.mechservice.solver.force.law;

/**
 * The smooth positive part pos(x) = (x + √(x² + ε²)) / 2, its derivatives and its integral. For ε =
 * 0 it is the positive part itself, with slope 1/2 at zero.
 */
final class SmoothPositive {
  private SmoothPositive() {}

  /** Returns pos(x), without cancellation where x is negative. */
  static double value(double x, double eps) {
    double s = Math.sqrt(x * x + eps * eps);
    if (x >= 0) {
      return 0.5 * (x + s);
    }
    return eps == 0 ? 0 : 0.5 * eps * (eps / (s - x));
  }

  /** Returns pos′(x), between 0 and 1. */
  static double slope(double x, double eps) {
    double s = Math.sqrt(x * x + eps * eps);
    if (s == 0) {
      return 0.5;
    }
    return value(x, eps) / s;
  }

  /** Returns pos″(x) ≥ 0. */
  static double bend(double x, double eps) {
    double s = Math.sqrt(x * x + eps * eps);
    if (s == 0 || eps == 0) {
      return 0;
    }
    double ratio = eps / s;
    return 0.5 * ratio * (ratio / s);
  }

  /**
   * Returns ∫ pos(x)ⁿ dx. With p = pos(x), x = p − ε²/(4p), so it is p^(n+1)/(n+1) + ε² p^(n−1) /
   * (4 (n−1)), which tends to zero for x → −∞; for n = 1 that limit does not exist, and the
   * integral starts at x = 0.
   *
   * @param n at least 1
   */
  static double integral(double x, double eps, double n) {
    double p = value(x, eps);
    if (p == 0) {
      return 0;
    }
    double quarter = 0.25 * eps * eps;
    if (n == 1) {
      double soft = eps == 0 ? 0 : quarter * (StrictMath.log(2 * p / eps) - 0.5);
      return 0.5 * p * p + soft;
    }
    double power = power(p, n - 1);
    return power * p * p / (n + 1) + quarter * power / (n - 1);
  }

  /**
   * Returns pⁿ for p ≥ 0; the exponents 0.5, 1 and 1.5, which are usual in contacts, use no
   * logarithm.
   */
  static double power(double p, double n) {
    if (n == 1) {
      return p;
    } else if (n == 0.5) {
      return Math.sqrt(p);
    } else if (n == 1.5) {
      return p * Math.sqrt(p);
    } else if (n == 0) {
      return 1;
    } else if (p == 0) {
      return n > 0 ? 0 : Double.POSITIVE_INFINITY;
    }
    return StrictMath.exp(n * StrictMath.log(p));
  }
}
