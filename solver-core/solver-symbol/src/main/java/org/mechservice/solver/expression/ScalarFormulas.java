package org.mechservice.solver.expression;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Quotient;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;

/** Scalars as expressions: the way back from {@link Formulas}. */
public final class ScalarFormulas {
  private final List<Expression> inputs;
  private final Map<Scalar, Expression> known = new HashMap<>();

  /**
   * @param inputs the expression of each input of the scalars
   */
  public ScalarFormulas(List<Expression> inputs) {
    this.inputs = List.copyOf(inputs);
  }

  /** Returns a scalar as an expression. */
  public Expression of(Scalar scalar) {
    Expression expression = known.get(scalar);
    if (expression == null) {
      expression = expression(scalar, scalar.operands().stream().map(this::of).toList());
      known.put(scalar, expression);
    }
    return expression;
  }

  private Expression expression(Scalar scalar, List<Expression> x) {
    return switch (scalar.operation()) {
      case CONSTANT -> Expression.of(scalar.value());
      case INPUT -> inputs.get(scalar.index());
      case ADD -> new Sum(x.get(0), x.get(1));
      case SUBTRACT -> difference(x.get(0), x.get(1));
      case MULTIPLY -> new Product(x.get(0), x.get(1));
      case DIVIDE -> new Quotient(x.get(0), x.get(1));
      case NEGATE -> new Negation(x.get(0));
      case SQUARE_ROOT -> new Call(MathFunction.SQRT, x);
      case SINE -> new Call(MathFunction.SIN, x);
      case COSINE -> new Call(MathFunction.COS, x);
      case FUNCTION -> function(scalar.function(), x);
    };
  }

  /** A choice becomes the sum of its parts, one of which is 0. */
  private static Expression function(MathFunction function, List<Expression> x) {
    if (function != MathFunction.CHOOSE) {
      return Expression.call(function, x);
    }
    Expression side = difference(x.get(1), x.get(0));
    Expression first = Expression.call(MathFunction.WHERE, List.of(side, x.get(2)));
    Expression second = Expression.call(MathFunction.ELSEWHERE, List.of(side, x.get(3)));
    return total(first, second);
  }

  private static Expression total(Expression a, Expression b) {
    return isZero(a) ? b : isZero(b) ? a : new Sum(a, b);
  }

  private static boolean isZero(Expression x) {
    return x instanceof Call call
        && call.function().isPart()
        && call.arguments().get(1).equals(Expression.ZERO);
  }

  private static Expression difference(Expression a, Expression b) {
    return b.equals(Expression.ZERO)
        ? a
        : a.equals(Expression.ZERO) ? new Negation(b) : new Sum(a, new Negation(b));
  }
}
