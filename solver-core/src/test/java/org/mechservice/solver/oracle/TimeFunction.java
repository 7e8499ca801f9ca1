package org.mechservice.solver.oracle;

import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Function;

/** Expressions of time alone, for prescribed motions. */
final class TimeFunction {
  private TimeFunction() {}

  /** Returns the value of an expression along a motion of time. */
  static Taylor of(Expression expression, Taylor time) {
    if (expression instanceof Expression.Constant constant) {
      return Taylor.of(constant.value());
    }
    if (expression instanceof Expression.Time) {
      return time;
    }
    if (expression instanceof Expression.Sum sum) {
      return of(sum.left(), time).plus(of(sum.right(), time));
    }
    if (expression instanceof Expression.Product product) {
      return of(product.left(), time).times(of(product.right(), time));
    }
    if (expression instanceof Expression.Negation negation) {
      return of(negation.operand(), time).times(-1);
    }
    if (expression instanceof Expression.Call call && call.function() == Function.SIN) {
      return of(call.arguments().get(0), time).sin();
    }
    throw new IllegalArgumentException("the oracle cannot evaluate " + expression);
  }
}
