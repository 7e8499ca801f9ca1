package org.mechservice.solver.oracle;

import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.symbol.MathFunction;

/** Expressions of time, for prescribed motions, and of joint coordinates, for couplings. */
final class TimeFunction {
  /** How joint coordinates move. */
  interface Coordinates {
    Taylor of(Coordinate coordinate);
  }

  private TimeFunction() {}

  /** Returns the value of an expression of time alone. */
  static Taylor of(Expression expression, Taylor time) {
    return of(
        expression,
        time,
        coordinate -> {
          throw new IllegalArgumentException("a prescribed motion depends on " + coordinate);
        });
  }

  /** Returns the value of an expression along a motion of time and coordinates. */
  static Taylor of(Expression expression, Taylor time, Coordinates position) {
    if (expression instanceof Expression.CoordinatePosition coordinate) {
      return position.of(coordinate.coordinate());
    }
    if (expression instanceof Expression.Constant constant) {
      return Taylor.of(constant.value());
    }
    if (expression instanceof Expression.Time) {
      return time;
    }
    if (expression instanceof Expression.Sum sum) {
      return of(sum.left(), time, position).plus(of(sum.right(), time, position));
    }
    if (expression instanceof Expression.Product product) {
      return of(product.left(), time, position).times(of(product.right(), time, position));
    }
    if (expression instanceof Expression.Negation negation) {
      return of(negation.operand(), time, position).times(-1);
    }
    if (expression instanceof Expression.Call call && call.function() == MathFunction.SIN) {
      return of(call.arguments().get(0), time, position).sin();
    }
    throw new IllegalArgumentException("the oracle cannot evaluate " + expression);
  }
}
