package org.mechservice.solver.symbol;

/**
 * Partial derivatives of functions without case distinctions. The derivative at a jump or corner is
 * one-sided.
 */
final class FunctionSlopes {
  /** Argument from which the slope of tanh, 4 e^(−2x), is below 1e-300 and is set to 0. */
  private static final double LEVEL = 350;

  private FunctionSlopes() {}

  /** Returns the derivative of a function by one of its arguments. */
  static Scalar slope(Scalar node, int argument) {
    Expressions e = node.expressions();
    Scalar x = node.first();
    return switch (node.function()) {
      case ABS -> e.function(MathFunction.SIGNUM, x);
      case SIN -> e.function(MathFunction.COS, x);
      case COS -> e.function(MathFunction.SIN, x).negated();
      case ASIN -> e.one().over(e.one().minus(x.squared()).squareRoot());
      case ACOS -> e.one().over(e.one().minus(x.squared()).squareRoot()).negated();
      case ATAN -> e.one().over(e.one().plus(x.squared()));
      case EXP -> node;
      case LOG -> e.one().over(x);
      case SINH -> e.function(MathFunction.COSH, x);
      case COSH -> e.function(MathFunction.SINH, x);
      case TANH -> ofTanh(e, x);
      case SIGNUM, FLOOR, PICK, HELD, INTERVAL, ELEMENT, CLOSEST -> e.zero();
      case ATAN2 -> ofAngle(node, argument);
      case HYPOT -> node.operands().get(argument).over(notZero(node));
      case PRODUCT -> argument == 0 ? node.second() : x;
      case POWER -> ofPower(node, argument);
      case MIN, MAX, CHOOSE ->
          throw new IllegalArgumentException(
              node.function() + " has cases: Differentiation chooses between their derivatives");
    };
  }

  /**
   * 1/cosh² keeps its digits where 1 − tanh² has none left; 0 where its square may overflow, of
   * which further slopes would be ∞/∞.
   */
  private static Scalar ofTanh(Expressions e, Scalar x) {
    Scalar slope = e.one().over(e.function(MathFunction.COSH, x).squared());
    Scalar size = e.function(MathFunction.ABS, x);
    return e.function(MathFunction.CHOOSE, size, e.constant(LEVEL), slope, e.zero());
  }

  private static Scalar ofAngle(Scalar node, int argument) {
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
  private static Scalar notZero(Scalar size) {
    Expressions e = size.expressions();
    return e.function(MathFunction.CHOOSE, size, e.zero(), e.one(), size);
  }

  /** b a^(b−1), and aᵇ ln a, which is 0 at a = 0. */
  private static Scalar ofPower(Scalar node, int argument) {
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
}
