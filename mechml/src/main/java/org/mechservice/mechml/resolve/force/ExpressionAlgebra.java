package org.mechservice.mechml.resolve.force;

import java.util.IdentityHashMap;
import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.Composed;
import org.mechservice.solver.expression.Expression.Constant;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.Power;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Quotient;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.TableValue;
import org.mechservice.solver.symbol.MathFunction;

/**
 * Arithmetic of expressions, in which numbers are computed at once and terms that are zero vanish.
 * The results share their operands: an expression that is used twice stands there once.
 */
final class ExpressionAlgebra {
  private ExpressionAlgebra() {}

  static Expression sum(Expression a, Expression b) {
    if (a instanceof Constant x && b instanceof Constant y) {
      return Expression.of(x.value() + y.value());
    } else if (isZero(a)) {
      return b;
    } else if (isZero(b)) {
      return a;
    }
    boolean opposite = b instanceof Negation minus && minus.operand() == a;
    return opposite ? Expression.ZERO : new Sum(a, b);
  }

  static Expression minus(Expression a, Expression b) {
    return sum(a, negated(b));
  }

  static Expression negated(Expression a) {
    if (a instanceof Constant x) {
      return Expression.of(0 - x.value());
    }
    return a instanceof Negation minus ? minus.operand() : new Negation(a);
  }

  static Expression product(Expression a, Expression b) {
    if (a instanceof Constant x && b instanceof Constant y) {
      return Expression.of(x.value() * y.value());
    } else if (isZero(a) || isZero(b)) {
      return Expression.ZERO;
    } else if (isOne(a)) {
      return b;
    }
    return isOne(b) ? a : new Product(a, b);
  }

  static Expression times(double factor, Expression a) {
    return product(Expression.of(factor), a);
  }

  static Expression square(Expression a) {
    return product(a, a);
  }

  static Expression quotient(Expression a, Expression b) {
    if (a instanceof Constant x && b instanceof Constant y) {
      return Expression.of(x.value() / y.value());
    }
    return isZero(a) || isOne(b) ? a : new Quotient(a, b);
  }

  static Expression power(Expression a, double exponent) {
    return exponent == 1 ? a : new Power(a, Expression.of(exponent));
  }

  static Expression root(Expression a) {
    return a instanceof Constant x
        ? Expression.of(StrictMath.sqrt(x.value()))
        : call(MathFunction.SQRT, a);
  }

  static Expression call(MathFunction function, Expression... arguments) {
    return Expression.call(function, List.of(arguments));
  }

  static Expression larger(Expression a, Expression b) {
    return call(MathFunction.MAX, a, b);
  }

  static Expression smaller(Expression a, Expression b) {
    return call(MathFunction.MIN, a, b);
  }

  static boolean isZero(Expression a) {
    return a instanceof Constant x && x.value() == 0;
  }

  private static boolean isOne(Expression a) {
    return a instanceof Constant x && x.value() == 1;
  }

  /** Returns a function of {@link Expression.Argument} at an argument. */
  static Expression at(Expression function, Expression argument) {
    return at(function, argument, new IdentityHashMap<>());
  }

  private static Expression at(
      Expression e, Expression x, IdentityHashMap<Expression, Expression> done) {
    Expression known = done.get(e);
    if (known == null) {
      known = substituted(e, x, done);
      done.put(e, known);
    }
    return known;
  }

  private static Expression substituted(
      Expression e, Expression x, IdentityHashMap<Expression, Expression> done) {
    if (e instanceof Expression.Argument) {
      return x;
    } else if (e instanceof Sum sum) {
      return new Sum(at(sum.left(), x, done), at(sum.right(), x, done));
    } else if (e instanceof Product product) {
      return new Product(at(product.left(), x, done), at(product.right(), x, done));
    } else if (e instanceof Quotient quotient) {
      return new Quotient(at(quotient.dividend(), x, done), at(quotient.divisor(), x, done));
    } else if (e instanceof Power power) {
      return new Power(at(power.base(), x, done), at(power.exponent(), x, done));
    } else if (e instanceof Negation negation) {
      return new Negation(at(negation.operand(), x, done));
    } else if (e instanceof TableValue value) {
      return new TableValue(
          value.table(), value.arguments().stream().map(one -> at(one, x, done)).toList());
    } else if (e instanceof Call call) {
      return Expression.call(
          call.function(), call.arguments().stream().map(one -> at(one, x, done)).toList());
    } else if (e instanceof Composed call) {
      return Expression.call(
          call.function(), call.arguments().stream().map(one -> at(one, x, done)).toList());
    }
    return e;
  }
}
