package org.mechservice.mechml.resolve.formula;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.expression.ConstantEvaluation;
import org.mechservice.mechml.expression.ExpressionException;
import org.mechservice.mechml.expression.ParsedExpression;
import org.mechservice.mechml.expression.Scope;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.PointFunction;

/**
 * Translates a parsed expression to one of the solver: resolves names and evaluates constant parts.
 * Constant parts must be finite; the run checks the others.
 */
final class FormulaTranslation {
  /** Largest number of operations; a deeper tree could overflow the stack. */
  private static final int MOST_OPERATIONS = 2000;

  private final FormulaNames names;
  private final FormulaRole role;
  private int operations;

  private FormulaTranslation(FormulaNames names, FormulaRole role) {
    this.names = names;
    this.role = role;
  }

  /**
   * Returns the formula in the units of formulas.
   *
   * @throws ExpressionException if a name is unknown or not allowed, or a constant part has no
   *     finite value
   */
  static Expression of(ParsedExpression parsed, FormulaNames names, FormulaRole role)
      throws ExpressionException {
    return new FormulaTranslation(names, role).translate(parsed);
  }

  private Expression translate(ParsedExpression parsed) throws ExpressionException {
    operations++;
    if (operations > MOST_OPERATIONS) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_SYNTAX,
          parsed.offset(),
          "more than " + MOST_OPERATIONS + " operands in one expression");
    }
    if (parsed instanceof ParsedExpression.Literal literal) {
      return new Expression.Constant(literal.value());
    }
    if (parsed instanceof ParsedExpression.Reference reference) {
      return names.leaf(reference, role);
    }
    if (parsed instanceof ParsedExpression.Sum sum) {
      return sum(sum);
    }
    if (parsed instanceof ParsedExpression.Product product) {
      return product(product);
    }
    if (parsed instanceof ParsedExpression.Negation negation) {
      return negation(negation);
    }
    if (parsed instanceof ParsedExpression.Power power) {
      return power(power);
    }
    if (parsed instanceof ParsedExpression.TableCall call) {
      return table(call);
    }
    return call((ParsedExpression.Call) parsed);
  }

  /** Returns the values as literals if all operands are constant; otherwise an empty list. */
  private static List<ParsedExpression> literals(List<Expression> operands, int offset) {
    List<ParsedExpression> literals = new ArrayList<>();
    for (Expression operand : operands) {
      if (!(operand instanceof Expression.Constant constant)) {
        return List.of();
      }
      literals.add(new ParsedExpression.Literal(constant.value(), offset));
    }
    return literals;
  }

  /** Evaluates an operation on literals by the rules of constant expressions. */
  private static Expression worked(ParsedExpression operation) throws ExpressionException {
    return new Expression.Constant(ConstantEvaluation.of(operation, Scope.CONSTANTS) + 0.0);
  }

  private List<Expression> operands(List<ParsedExpression.Part> parts) throws ExpressionException {
    List<Expression> operands = new ArrayList<>();
    for (ParsedExpression.Part part : parts) {
      operands.add(translate(part.operand()));
    }
    return operands;
  }

  private static List<ParsedExpression.Part> parts(
      List<ParsedExpression.Part> parts, List<ParsedExpression> operands) {
    List<ParsedExpression.Part> replaced = new ArrayList<>();
    for (int i = 0; i < operands.size(); i++) {
      ParsedExpression.Part part = parts.get(i);
      replaced.add(new ParsedExpression.Part(part.inverse(), operands.get(i), part.offset()));
    }
    return replaced;
  }

  private Expression sum(ParsedExpression.Sum sum) throws ExpressionException {
    List<Expression> operands = operands(sum.parts());
    List<ParsedExpression> literals = literals(operands, sum.offset());
    if (!literals.isEmpty()) {
      return worked(new ParsedExpression.Sum(parts(sum.parts(), literals), sum.offset()));
    }
    Expression total = operands.get(0);
    for (int i = 1; i < operands.size(); i++) {
      Expression operand = operands.get(i);
      total =
          new Expression.Sum(
              total, sum.parts().get(i).inverse() ? new Expression.Negation(operand) : operand);
    }
    return total;
  }

  private Expression product(ParsedExpression.Product product) throws ExpressionException {
    List<Expression> operands = operands(product.parts());
    List<ParsedExpression> literals = literals(operands, product.offset());
    if (!literals.isEmpty()) {
      return worked(
          new ParsedExpression.Product(parts(product.parts(), literals), product.offset()));
    }
    Expression total = operands.get(0);
    for (int i = 1; i < operands.size(); i++) {
      Expression operand = operands.get(i);
      if (!product.parts().get(i).inverse()) {
        total = new Expression.Product(total, operand);
      } else if (operand instanceof Expression.Constant c && c.value() == 0) {
        throw new ExpressionException(
            MessageCode.EXPRESSION_VALUE, product.parts().get(i).offset(), "division by zero");
      } else {
        total = new Expression.Quotient(total, operand);
      }
    }
    return total;
  }

  private Expression negation(ParsedExpression.Negation negation) throws ExpressionException {
    Expression operand = translate(negation.operand());
    return operand instanceof Expression.Constant constant
        ? new Expression.Constant(0 - constant.value())
        : new Expression.Negation(operand);
  }

  private Expression power(ParsedExpression.Power power) throws ExpressionException {
    Expression base = translate(power.base());
    Expression exponent = translate(power.exponent());
    List<ParsedExpression> literals = literals(List.of(base, exponent), power.offset());
    return literals.isEmpty()
        ? new Expression.Power(base, exponent)
        : worked(new ParsedExpression.Power(literals.get(0), literals.get(1), power.offset()));
  }

  private Expression table(ParsedExpression.TableCall call) throws ExpressionException {
    PointFunction table = Objects.requireNonNull(names.tables().get(call.table()));
    List<Expression> arguments = new ArrayList<>();
    List<Double> constants = new ArrayList<>();
    for (ParsedExpression argument : call.arguments()) {
      arguments.add(translate(argument));
      if (arguments.get(arguments.size() - 1) instanceof Expression.Constant constant) {
        constants.add(constant.value());
      }
    }
    if (constants.size() < arguments.size()) {
      return new Expression.TableValue(table, arguments);
    }
    double value = table.at(constants);
    if (!Double.isFinite(value)) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_VALUE,
          call.offset(),
          Phrase.of(
              constants.size() == 1
                  ? "table %s has no value at %s: its arguments go from %s"
                  : "map %s has no value at %s: its arguments go from %s",
              table.name(),
              constants.stream().map(Object::toString).collect(Collectors.joining(", ")),
              table.grid().stream()
                  .map(points -> points.get(0) + " to " + points.get(points.size() - 1))
                  .collect(Collectors.joining(", and from "))));
    }
    return new Expression.Constant(value);
  }

  private Expression call(ParsedExpression.Call call) throws ExpressionException {
    List<Expression> arguments = new ArrayList<>();
    for (ParsedExpression argument : call.arguments()) {
      arguments.add(translate(argument));
    }
    List<ParsedExpression> literals = literals(arguments, call.offset());
    if (!literals.isEmpty()) {
      return worked(new ParsedExpression.Call(call.function(), literals, call.offset()));
    }
    return Expression.call(call.function(), arguments);
  }
}
