package org.mechservice.solver.force.law;

import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;

/**
 * The smooth positive part pos(x) = (x + √(x² + ε²)) / 2 and related functions. For ε = 0 it is the
 * positive part itself, with slope 1/2 at zero. Where ε is not known as code is made, both forms
 * are there and ε chooses.
 */
final class SmoothPart {
  private final Expressions e;
  private final Scalar x;
  private final Scalar eps;

  /** √(x² + ε²). */
  private final Scalar root;

  SmoothPart(Scalar x, Scalar eps) {
    this.e = x.expressions();
    this.x = x;
    this.eps = eps;
    this.root = x.squared().plus(eps.squared()).squareRoot();
  }

  private Scalar choose(Scalar a, Scalar b, Scalar first, Scalar second) {
    return e.function(MathFunction.CHOOSE, a, b, first, second);
  }

  /** Returns pos(x) = (x + |x|)/2 + pos(−|x|), pos(−|x|) = ε² / (2 (|x| + √(x² + ε²))). */
  Scalar value() {
    Scalar hard = choose(e.zero(), x, x, e.zero());
    if (eps.isZero()) {
      return hard;
    }
    Scalar size = e.function(MathFunction.ABS, x);
    Scalar soft = eps.squared().times(0.5).over(size.plus(root));
    return choose(eps, e.zero(), hard, x.plus(size).times(0.5).plus(soft));
  }

  /** Returns pos′(x), between 0 and 1, for ε &gt; 0. */
  Scalar slope() {
    return value().over(root);
  }

  /** Returns ∫ pos(x)ⁿ dx; for n = 1 it is taken from x = 0, else from far below. */
  Scalar integral(Scalar n) {
    if (n.isConstant()) {
      return n.value() == 1 ? ofFirstPower() : ofHigherPower(n);
    }
    return choose(n, e.one(), ofFirstPower(), ofHigherPower(n));
  }

  private Scalar ofFirstPower() {
    Scalar p = value();
    Scalar half = p.squared().times(0.5);
    if (eps.isZero()) {
      return half;
    }
    Scalar log = e.function(MathFunction.LOG, p.times(e.constant(2).over(eps)));
    Scalar soft = half.plus(log.minus(e.constant(0.5)).times(quarter()));
    return choose(eps, e.zero(), half, soft);
  }

  private Scalar ofHigherPower(Scalar n) {
    Scalar p = value();
    Scalar power = raised(p, n.minus(e.one()));
    Scalar share = e.one().over(n.plus(e.one()));
    Scalar soft = power.times(quarter().over(n.minus(e.one())));
    return power.times(p.squared()).times(share).plus(soft);
  }

  private Scalar quarter() {
    return eps.squared().times(0.25);
  }

  /** Returns pos(x)ⁿ for n ≥ 1; with ε = 0 the root of zero is left out where x is negative. */
  Scalar power(Scalar n) {
    boolean first = n.isConstant() && n.value() == 1;
    if (first || (eps.isConstant() && !eps.isZero())) {
      return raised(value(), n);
    }
    Scalar hard = choose(x, e.zero(), e.zero(), raised(x, n));
    return eps.isZero() ? hard : choose(eps, e.zero(), hard, raised(value(), n));
  }

  /** Returns pⁿ for p ≥ 0. */
  private Scalar raised(Scalar p, Scalar n) {
    if (n.isZero()) {
      return e.one();
    } else if (n.isConstant() && n.value() == 1) {
      return p;
    } else if (n.isConstant() && n.value() == 0.5) {
      return p.squareRoot();
    } else if (n.isConstant() && n.value() == 1.5) {
      return p.times(p.squareRoot());
    }
    return e.function(MathFunction.POWER, p, n);
  }
}
