package org.mechservice.sim.equations.force;

import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;

/**
 * The smooth positive part pos(x) = (x + √(x² + ε²)) / 2 and related functions. For ε = 0 it is the
 * positive part itself, with slope 1/2 at zero.
 */
final class SmoothPart {
  private final Expressions e;
  private final Scalar x;
  private final double eps;

  /** √(x² + ε²). */
  private final Scalar root;

  SmoothPart(Scalar x, double eps) {
    this.e = x.expressions();
    this.x = x;
    this.eps = eps;
    this.root = x.squared().plus(e.constant(eps * eps)).squareRoot();
  }

  private Scalar choose(Scalar a, Scalar b, Scalar first, Scalar second) {
    return e.function(MathFunction.CHOOSE, a, b, first, second);
  }

  /** Returns pos(x), without cancellation where x is negative. */
  Scalar value() {
    if (eps == 0) {
      return choose(e.zero(), x, x, e.zero());
    }
    Scalar below = e.constant(eps).over(root.minus(x)).times(0.5 * eps);
    return choose(e.zero(), x, x.plus(root).times(0.5), below);
  }

  /** Returns pos′(x), between 0 and 1. */
  Scalar slope() {
    if (eps == 0) {
      Scalar upToZero = choose(e.zero(), x, e.constant(0.5), e.zero());
      return choose(x, e.zero(), upToZero, e.one());
    }
    return value().over(root);
  }

  /** Returns ∫ pos(x)ⁿ dx; for n = 1 it is taken from x = 0, else from far below. */
  Scalar integral(double n) {
    Scalar p = value();
    double quarter = 0.25 * eps * eps;
    if (n == 1) {
      Scalar half = p.squared().times(0.5);
      if (eps == 0) {
        return half;
      }
      Scalar log = e.function(MathFunction.LOG, p.times(2 / eps));
      return half.plus(log.minus(e.constant(0.5)).times(quarter));
    }
    Scalar power = raised(p, n - 1);
    return power.times(p.squared()).times(1 / (n + 1)).plus(power.times(quarter / (n - 1)));
  }

  /** Returns pos(x)ⁿ for n ≥ 1; with ε = 0 the root of zero is left out where x is negative. */
  Scalar power(double n) {
    return eps == 0 && n != 1 ? choose(x, e.zero(), e.zero(), raised(x, n)) : raised(value(), n);
  }

  /** Returns pⁿ for p ≥ 0. */
  private Scalar raised(Scalar p, double n) {
    if (n == 0) {
      return e.one();
    } else if (n == 1) {
      return p;
    } else if (n == 0.5) {
      return p.squareRoot();
    } else if (n == 1.5) {
      return p.times(p.squareRoot());
    }
    return e.function(MathFunction.POWER, p, e.constant(n));
  }
}
