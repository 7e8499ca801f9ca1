package org.mechservice.solver.expression;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.Power;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Quotient;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;

/**
 * Scalars as expressions, the way back from {@link Formulas}: for what is asked of formulas, such
 * as where they change their form. A choice becomes a sum with steps, so what is not chosen must be
 * finite too if the expression is to have a value.
 */
public final class ScalarFormulas {
  private static final Expression ONE = Expression.of(1);

  private final List<Expression> inputs;
  private final Map<Scalar, Expression> known = new HashMap<>();

  /**
   * @param inputs the expression of each input of the scalars
   */
  public ScalarFormulas(List<Expression> inputs) {
    this.inputs = List.copyOf(inputs);
  }

  /**
   * Returns a scalar as an expression.
   *
   * @throws IllegalArgumentException if it reads a table or searches
   */
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
      case SQUARE_ROOT -> Expression.call(Function.SQRT, x);
      case SINE -> Expression.call(Function.SIN, x);
      case COSINE -> Expression.call(Function.COS, x);
      case FUNCTION -> function(scalar.function(), x);
    };
  }

  private static Expression difference(Expression a, Expression b) {
    return new Sum(a, new Negation(b));
  }

  private static Expression function(MathFunction function, List<Expression> x) {
    return switch (function) {
      case ABS -> Expression.call(Function.ABS, x);
      case SIN -> Expression.call(Function.SIN, x);
      case COS -> Expression.call(Function.COS, x);
      case ASIN -> Expression.call(Function.ASIN, x);
      case ACOS -> Expression.call(Function.ACOS, x);
      case ATAN -> Expression.call(Function.ATAN, x);
      case ATAN2 -> Expression.call(Function.ATAN2, x);
      case EXP -> Expression.call(Function.EXP, x);
      case LOG -> Expression.call(Function.LOG, x);
      case SINH -> Expression.call(Function.SINH, x);
      case COSH -> Expression.call(Function.COSH, x);
      case TANH -> Expression.call(Function.TANH, x);
      case HYPOT -> Expression.call(Function.HYPOT, x);
      case MIN -> Expression.call(Function.MIN, x);
      case MAX -> Expression.call(Function.MAX, x);
      case SIGNUM -> Expression.call(Function.SIGNUM, x);
      case FLOOR -> Expression.call(Function.FLOOR, x);
      case POWER -> new Power(x.get(0), x.get(1));
      case PRODUCT -> new Product(x.get(0), x.get(1));
      case HELD -> x.get(0);
      case CHOOSE, PICK -> {
        Expression second = Expression.call(Function.STEP, List.of(difference(x.get(0), x.get(1))));
        Expression first = difference(ONE, second);
        yield new Sum(new Product(first, x.get(2)), new Product(second, x.get(3)));
      }
      case INTERVAL, ELEMENT, CLOSEST ->
          throw new IllegalArgumentException(function + " reads a row of numbers");
    };
  }
}
