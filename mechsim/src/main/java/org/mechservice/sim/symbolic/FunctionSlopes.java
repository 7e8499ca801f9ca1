package org.mechservice.sim.symbolic;

/**
 * Partial derivatives of functions. Where a function jumps or has a corner, that of one side; where
 * its slope is vertical, 0, so that what does not change there does not become 0 · ∞.
 */
final class FunctionSlopes {
  /** From here on the slope of tanh, 4 e^(−2x), is below 1e-300 and counts as level. */
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
      case ASIN -> e.one().over(awayFromZero(e.one().minus(x.squared()).squareRoot()));
      case ACOS -> e.one().over(awayFromZero(e.one().minus(x.squared()).squareRoot())).negated();
      case ATAN -> e.one().over(e.one().plus(x.squared()));
      case EXP -> node;
      case LOG -> e.one().over(x);
      case SINH -> e.function(MathFunction.COSH, x);
      case COSH -> e.function(MathFunction.SINH, x);
      case TANH -> ofTanh(e, x);
      case SIGNUM, FLOOR -> e.zero();
      default -> ofTwo(node, argument);
    };
  }

  /**
   * 1/cosh² keeps its digits where 1 − tanh² has none left; of no angle so large that its square
   * overflows, of which further slopes would be ∞/∞.
   */
  private static Scalar ofTanh(Expressions e, Scalar x) {
    Scalar below = e.function(MathFunction.MIN, e.constant(LEVEL), x);
    Scalar within = e.function(MathFunction.MAX, e.constant(-LEVEL), below);
    return e.one().over(e.function(MathFunction.COSH, within).squared());
  }

  private static Scalar ofTwo(Scalar node, int argument) {
    Scalar x = node.first();
    Scalar y = node.second();
    Scalar other = argument == 0 ? y : x;
    return switch (node.function()) {
      case ATAN2 -> {
        Scalar perSquare = other.over(awayFromZero(x.squared().plus(y.squared())));
        yield argument == 0 ? perSquare : perSquare.negated();
      }
      case HYPOT -> ofHypot(node, argument);
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
      Scalar slope = b.times(e.function(MathFunction.POWER, a, b.minus(e.one())));
      Scalar size = e.function(MathFunction.ABS, a);
      boolean vertical = !(b.isConstant() && b.value() >= 1);
      return vertical ? e.function(MathFunction.CHOOSE, size, e.zero(), e.zero(), slope) : slope;
    }
    Scalar base = e.function(MathFunction.CHOOSE, a, e.zero(), e.one(), a);
    return node.times(e.function(MathFunction.LOG, base));
  }

  /** Returns a divisor that is not negative, or one that leaves nothing where that is zero. */
  static Scalar awayFromZero(Scalar divisor) {
    Expressions e = divisor.expressions();
    Scalar most = e.constant(Double.MAX_VALUE);
    return e.function(MathFunction.CHOOSE, divisor, e.zero(), most, divisor);
  }
}
