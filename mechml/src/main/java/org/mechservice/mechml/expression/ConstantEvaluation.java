package org.mechservice.mechml.expression;

import java.util.List;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.symbol.MathFunction;

/**
 * Computes the value of a constant expression in a scope, with the bits that a run would give it;
 * every intermediate value must be finite.
 */
public final class ConstantEvaluation {
  private final Scope scope;

  private ConstantEvaluation(Scope scope) {
    this.scope = scope;
  }

  /**
   * Returns the value of an expression.
   *
   * @return a finite number
   * @throws ExpressionException if a name is unknown or a part has no finite value
   */
  public static double of(ParsedExpression expression, Scope scope) throws ExpressionException {
    return new ConstantEvaluation(scope).value(expression);
  }

  /**
   * Returns the value of a text: a number, or an expression of numbers and {@code PI}.
   *
   * @return a finite number
   * @throws ExpressionException if the text is no such expression or has no finite value
   */
  public static double of(String text) throws ExpressionException {
    return finite(of(ExpressionParser.parse(text), Scope.CONSTANTS) + 0.0, 0, "the value");
  }

  private double value(ParsedExpression expression) throws ExpressionException {
    if (expression instanceof ParsedExpression.Literal literal) {
      return literal.value();
    }
    if (expression instanceof ParsedExpression.Reference reference) {
      return finite(scope.value(reference), reference.offset(), reference.text());
    }
    if (expression instanceof ParsedExpression.Sum sum) {
      return sum(sum);
    }
    if (expression instanceof ParsedExpression.Product product) {
      return product(product);
    }
    if (expression instanceof ParsedExpression.Negation negation) {
      return 0 - value(negation.operand());
    }
    if (expression instanceof ParsedExpression.Power power) {
      return power(power);
    }
    return call((ParsedExpression.Call) expression);
  }

  private double sum(ParsedExpression.Sum sum) throws ExpressionException {
    double total = value(sum.parts().get(0).operand());
    for (ParsedExpression.Part part : rest(sum.parts())) {
      double operand = value(part.operand());
      total = finite(part.inverse() ? total - operand : total + operand, part.offset(), "the sum");
    }
    return total;
  }

  private double product(ParsedExpression.Product product) throws ExpressionException {
    double total = value(product.parts().get(0).operand());
    for (ParsedExpression.Part part : rest(product.parts())) {
      double operand = value(part.operand());
      if (part.inverse() && operand == 0) {
        throw new ExpressionException(
            MessageCode.EXPRESSION_VALUE, part.offset(), "division by zero");
      }
      double next = part.inverse() ? total / operand : total * operand;
      total = finite(next, part.offset(), "the product");
    }
    return total;
  }

  private static List<ParsedExpression.Part> rest(List<ParsedExpression.Part> parts) {
    return parts.subList(1, parts.size());
  }

  private double power(ParsedExpression.Power power) throws ExpressionException {
    double base = value(power.base());
    double exponent = value(power.exponent());
    return finite(
        MathFunction.POWER.value(base, exponent),
        power.offset(),
        Phrase.of("%s ^ %s", base, exponent));
  }

  private double call(ParsedExpression.Call call) throws ExpressionException {
    double[] arguments = new double[call.arguments().size()];
    StringBuilder shown = new StringBuilder(call.function().symbol()).append('(');
    for (int i = 0; i < arguments.length; i++) {
      arguments[i] = value(call.arguments().get(i));
      shown.append(i == 0 ? "" : ", ").append(arguments[i]);
    }
    return finite(call.function().value(arguments), call.offset(), shown.append(')').toString());
  }

  private static double finite(double value, int offset, String what) throws ExpressionException {
    if (Double.isFinite(value)) {
      return value;
    }
    throw new ExpressionException(
        MessageCode.EXPRESSION_VALUE,
        offset,
        what + (Double.isNaN(value) ? " is not a real number" : " is not finite"));
  }
}
