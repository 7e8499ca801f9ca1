package org.mechservice.sim.scene;

import java.util.List;
import org.mechservice.solver.expression.Expression;

/** Dependence of an expression on time and state; each kind includes those before it. */
enum Linearity {
  /** Depends on numbers and parameters only. */
  CONSTANT,
  /** Depends on time only. */
  OF_TIME,
  /** Linear in joint coordinates with constant coefficients, plus functions of time. */
  LINEAR,
  /** Anything else. */
  OTHER;

  /** Returns the kind of an expression, judged by its form without transformations. */
  static Linearity of(Expression e) {
    if (e instanceof Expression.Constant || e instanceof Expression.ParameterValue) {
      return CONSTANT;
    } else if (e instanceof Expression.Time) {
      return OF_TIME;
    } else if (e instanceof Expression.CoordinatePosition
        || e instanceof Expression.CoordinateVelocity) {
      return LINEAR;
    } else if (e instanceof Expression.Negation negation) {
      return of(negation.operand());
    } else if (e instanceof Expression.Sum sum) {
      return largest(List.of(sum.left(), sum.right()));
    } else if (e instanceof Expression.Product product) {
      Linearity left = of(product.left());
      Linearity right = of(product.right());
      return left == CONSTANT ? right : right == CONSTANT ? left : ofTimeAtMost(left, right);
    } else if (e instanceof Expression.Quotient quotient) {
      Linearity dividend = of(quotient.dividend());
      Linearity divisor = of(quotient.divisor());
      return divisor == CONSTANT ? dividend : ofTimeAtMost(dividend, divisor);
    } else if (e instanceof Expression.Power power) {
      return ofTimeAtMost(of(power.base()), of(power.exponent()));
    } else if (e instanceof Expression.Call call) {
      Linearity arguments = largest(call.arguments());
      return ofTimeAtMost(arguments, arguments);
    } else if (e instanceof Expression.Composed call) {
      Linearity arguments = largest(call.arguments());
      return ofTimeAtMost(arguments, arguments);
    } else if (e instanceof Expression.TableValue value) {
      return ofTimeAtMost(largest(value.arguments()), CONSTANT);
    }
    return OTHER;
  }

  private static Linearity largest(List<Expression> parts) {
    Linearity largest = CONSTANT;
    for (Expression part : parts) {
      Linearity kind = of(part);
      largest = kind.compareTo(largest) > 0 ? kind : largest;
    }
    return largest;
  }

  /** Returns the kind of a nonlinear function of two expressions. */
  private static Linearity ofTimeAtMost(Linearity a, Linearity b) {
    Linearity larger = a.compareTo(b) > 0 ? a : b;
    return larger.compareTo(OF_TIME) > 0 ? OTHER : larger;
  }
}
