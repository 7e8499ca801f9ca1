package org.mechservice.solver.symbol;

/**
 * Longer formulas of the catalogue of functions: slopes of calls, and what has no node of its own.
 */
final class FunctionFormulas {
  /** Argument from which the slope of tanh, 4 e^(−2x), is below 1e-300 and is set to 0. */
  private static final double LEVEL = 350;

  private FunctionFormulas() {}

  /** Returns a call without a mark. */
  static Scalar of(MathFunction function, Scalar... arguments) {
    return arguments[0].expressions().function(function, arguments);
  }

  /** The sign of x. */
  static Scalar ofSize(Scalar x) {
    return of(MathFunction.SIGNUM, x);
  }

  /** cosh x. */
  static Scalar ofHyperbolicSine(Scalar x) {
    return of(MathFunction.COSH, x);
  }

  /** 1 / (1 + x²). */
  static Scalar ofArcTangent(Scalar x) {
    Scalar one = x.expressions().one();
    return one.over(one.plus(x.squared()));
  }

  /** 1 / √(1 − x²). */
  static Scalar ofArcSine(Scalar x) {
    Scalar one = x.expressions().one();
    return one.over(one.minus(x.squared()).squareRoot());
  }

  /**
   * 1/cosh² keeps its digits where 1 − tanh² has none left; 0 where its square may overflow, of
   * which further slopes would be ∞/∞.
   */
  static Scalar ofTanh(Scalar x) {
    Expressions e = x.expressions();
    Scalar slope = e.one().over(e.function(MathFunction.COSH, x).squared());
    Scalar size = e.function(MathFunction.ABS, x);
    return e.function(MathFunction.CHOOSE, size, e.constant(LEVEL), slope, e.zero());
  }

  static Scalar ofAngle(Scalar node, int argument) {
    Scalar x = node.first();
    Scalar y = node.second();
    Scalar other = argument == 0 ? y : x;
    Scalar perSquare = other.over(notZero(x.squared().plus(y.squared())));
    return argument == 0 ? perSquare : perSquare.negated();
  }

  /**
   * Returns 1 instead of 0, so that slopes count as 0 at the origin, where the direction is not
   * defined.
   */
  static Scalar notZero(Scalar size) {
    Expressions e = size.expressions();
    return e.function(MathFunction.CHOOSE, size, e.zero(), e.one(), size);
  }

  /** b a^(b−1), and aᵇ ln a, which is 0 at a = 0. */
  static Scalar ofPower(Scalar node, int argument) {
    Expressions e = node.expressions();
    Scalar a = node.first();
    Scalar b = node.second();
    if (argument == 0) {
      // 0 · a^−1 leaves nothing, even at a = 0
      Scalar power = e.function(MathFunction.POWER, a, b.minus(e.one()));
      return e.function(MathFunction.PRODUCT, b, power);
    }
    Scalar base = e.function(MathFunction.CHOOSE, a, e.zero(), e.one(), a);
    return node.times(e.function(MathFunction.LOG, base));
  }

  /** x where a ≥ 0, else 0. */
  static Scalar where(Scalar a, Scalar x) {
    Expressions e = x.expressions();
    return of(MathFunction.CHOOSE, e.zero(), a, x, e.zero());
  }

  /** 0 where a ≥ 0, else x. */
  static Scalar elsewhere(Scalar a, Scalar x) {
    Expressions e = x.expressions();
    return of(MathFunction.CHOOSE, e.zero(), a, e.zero(), x);
  }

  /** 1 from zero on, else 0. */
  static Scalar step(Scalar x) {
    Expressions e = x.expressions();
    return of(MathFunction.CHOOSE, e.zero(), x, e.one(), e.zero());
  }

  /** s² (3 − 2 s) with s = x between 0 and 1. */
  static Scalar smoothStep(Scalar x) {
    Expressions e = x.expressions();
    Scalar below = of(MathFunction.MIN, e.one(), x);
    Scalar s = of(MathFunction.MAX, e.zero(), below);
    return s.squared().times(e.constant(3).minus(s.times(2)));
  }

  /** The same in doubles. */
  static double smoothStep(double x) {
    double s = Math.max(0, Math.min(1, x));
    return s * s * (3 - 2 * s);
  }
}
