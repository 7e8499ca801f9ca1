package org.mechservice.sim.symbolic;

/** Partial derivatives of functions. Where a function jumps or has a corner, that of one side. */
final class FunctionSlopes {
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
      // 1/cosh² keeps its digits where 1 − tanh² has none left
      case TANH -> e.one().over(e.function(MathFunction.COSH, x).squared());
      case SIGNUM, FLOOR -> e.zero();
      case CHOOSE -> chosen(node, argument);
      default -> ofTwo(node, argument);
    };
  }

  private static Scalar ofTwo(Scalar node, int argument) {
    Expressions e = node.expressions();
    Scalar x = node.first();
    Scalar y = node.second();
    Scalar other = argument == 0 ? y : x;
    return switch (node.function()) {
      case ATAN2 -> {
        Scalar perSquare = other.over(x.squared().plus(y.squared()));
        yield argument == 0 ? perSquare : perSquare.negated();
      }
      case HYPOT -> ofHypot(node, argument);
      case MIN ->
          e.function(
              MathFunction.CHOOSE, x, y, indicator(e, argument, 0), indicator(e, argument, 1));
      case MAX ->
          e.function(
              MathFunction.CHOOSE, y, x, indicator(e, argument, 0), indicator(e, argument, 1));
      case POWER -> ofPower(node, argument);
      default -> throw new IllegalArgumentException(node.function() + " has no derivative");
    };
  }

  /** At the origin, where it has a cone's tip, the slope counts as 0. */
  private static Scalar ofHypot(Scalar node, int argument) {
    Expressions e = node.expressions();
    Scalar length = e.function(MathFunction.CHOOSE, node, e.zero(), e.one(), node);
    return node.operands().get(argument).over(length);
  }

  /** b a^(b−1), and aᵇ ln a, which is 0 at a = 0. */
  private static Scalar ofPower(Scalar node, int argument) {
    Expressions e = node.expressions();
    Scalar a = node.first();
    Scalar b = node.second();
    if (argument == 0) {
      return b.times(e.function(MathFunction.POWER, a, b.minus(e.one())));
    }
    Scalar base = e.function(MathFunction.CHOOSE, a, e.zero(), e.one(), a);
    return node.times(e.function(MathFunction.LOG, base));
  }

  /** Only what is chosen counts. */
  private static Scalar chosen(Scalar node, int argument) {
    Expressions e = node.expressions();
    if (argument < 2) {
      return e.zero();
    }
    return e.function(
        MathFunction.CHOOSE,
        node.first(),
        node.second(),
        indicator(e, argument, 2),
        indicator(e, argument, 3));
  }

  private static Scalar indicator(Expressions e, int argument, int meant) {
    return argument == meant ? e.one() : e.zero();
  }
}
