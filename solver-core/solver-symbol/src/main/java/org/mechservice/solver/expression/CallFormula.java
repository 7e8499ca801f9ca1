package org.mechservice.solver.expression;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Quotient;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;

/** The formula that a function of the catalogue is, with expressions as arguments. */
final class CallFormula {
  private final List<Expression> arguments;
  private final Map<Scalar, Expression> known = new HashMap<>();

  CallFormula(List<Expression> arguments) {
    this.arguments = arguments;
  }

  Expression of(MathFunction function) {
    Expressions e = new Expressions();
    List<Scalar> inputs = IntStream.range(0, arguments.size()).mapToObj(e::input).toList();
    return of(function.call(inputs));
  }

  private Expression of(Scalar node) {
    Expression expression = known.get(node);
    if (expression == null) {
      expression = made(node);
      known.put(node, expression);
    }
    return expression;
  }

  private Expression made(Scalar node) {
    List<Expression> operands = node.operands().stream().map(this::of).toList();
    return switch (node.operation()) {
      case CONSTANT -> Expression.of(node.value());
      case INPUT -> arguments.get(node.index());
      case ADD -> new Sum(operands.get(0), operands.get(1));
      case SUBTRACT -> new Sum(operands.get(0), new Negation(operands.get(1)));
      case MULTIPLY -> new Product(operands.get(0), operands.get(1));
      case DIVIDE -> new Quotient(operands.get(0), operands.get(1));
      case NEGATE -> new Negation(operands.get(0));
      case SQUARE_ROOT -> new Call(MathFunction.SQRT, operands);
      case SINE -> new Call(MathFunction.SIN, operands);
      case COSINE -> new Call(MathFunction.COS, operands);
      case FUNCTION -> Expression.call(node.function(), operands);
    };
  }
}
