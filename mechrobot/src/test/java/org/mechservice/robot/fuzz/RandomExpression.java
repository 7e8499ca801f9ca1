package org.mechservice.robot.fuzz;

import java.util.List;
import java.util.Random;
import org.mechservice.solver.spatial.Powers;
import org.mechservice.solver.symbol.MathFunction;

/**
 * Draws expressions together with their values, worked out while they are written: what the parser
 * makes of the text must be the same number, to the last bit.
 *
 * @param text the expression
 * @param value its value; not a number if a part of it has none that is finite
 * @param binds how tightly its outermost operator binds
 */
record RandomExpression(String text, double value, int binds) {
  private static final int SUM = 1;
  private static final int PRODUCT = 2;
  private static final int SIGN = 3;
  private static final int POWER = 4;
  private static final int ATOM = 5;

  private static final List<MathFunction> FUNCTIONS = MathFunction.inFormulas();
  private static final List<String> NUMBERS =
      List.of("0", "1", "2", ".5", "3.", "1e3", "1E-2", "2.5e+1", "-1", "1e300", "1e-300");

  /** Draws an expression of at most some levels. */
  static RandomExpression draw(Random random, int levels) {
    if (levels == 0) {
      return atom(random);
    }
    RandomExpression a = draw(random, random.nextInt(levels));
    RandomExpression b = draw(random, random.nextInt(levels));
    return switch (random.nextInt(8)) {
      case 0 -> both(a, b, a.in(SUM) + " + " + b.in(PRODUCT), a.value + b.value, SUM);
      case 1 -> both(a, b, a.in(SUM) + "-" + b.in(PRODUCT), a.value - b.value, SUM);
      case 2 -> both(a, b, a.in(PRODUCT) + "*" + b.in(SIGN), a.value * b.value, PRODUCT);
      case 3 -> both(a, b, a.in(PRODUCT) + "/" + b.in(SIGN), a.value / b.value, PRODUCT);
      // 0 - x: no expression is -0 for its sign alone.
      case 4 -> both(a, a, "-" + a.in(POWER), 0 - a.value, SIGN);
      case 5 -> both(a, b, a.in(ATOM) + "^" + b.in(SIGN), Powers.power(a.value, b.value), POWER);
      default -> call(random, a, b);
    };
  }

  private static RandomExpression both(
      RandomExpression a, RandomExpression b, String text, double value, int binds) {
    boolean finite = Double.isFinite(a.value) && Double.isFinite(b.value) && Double.isFinite(value);
    return new RandomExpression(text, finite ? value : Double.NaN, binds);
  }

  private static RandomExpression atom(Random random) {
    if (random.nextInt(8) == 0) {
      return new RandomExpression("PI", StrictMath.PI, ATOM);
    }
    String number = NUMBERS.get(random.nextInt(NUMBERS.size()));
    boolean negative = number.startsWith("-");
    return new RandomExpression(number, Double.parseDouble(number), negative ? SIGN : ATOM);
  }

  private static RandomExpression call(Random random, RandomExpression a, RandomExpression b) {
    MathFunction function = FUNCTIONS.get(random.nextInt(FUNCTIONS.size()));
    String prefix = random.nextBoolean() ? "Math." : "";
    String arguments = function.arity() == 1 ? a.text : a.text + ", " + b.text;
    return both(
        a,
        function.arity() == 1 ? a : b,
        prefix + function.symbol() + "(" + arguments + ")",
        function.value(a.value, b.value),
        ATOM);
  }

  /** Returns the text, in brackets where what is around it binds more tightly. */
  private String in(int place) {
    return binds < place ? "(" + text + ")" : text;
  }
}
