package org.mechservice.mechml.expression;

import java.util.List;
import org.mechservice.mechml.diagnosis.MessageCode;
import org.mechservice.mechml.diagnosis.Nearest;
import org.mechservice.mechml.diagnosis.Quoted;

/** What the names in an expression stand for. */
@FunctionalInterface
public interface Scope {
  /** The names every expression knows: {@code PI}, also written {@code Math.PI}. */
  Scope CONSTANTS = Scope::constant;

  /**
   * Returns the value of a name.
   *
   * @throws ExpressionException if the name stands for nothing
   */
  double value(Expression.Reference name) throws ExpressionException;

  private static double constant(Expression.Reference name) throws ExpressionException {
    if (name.text().equals("PI") || name.text().equals("Math.PI")) {
      return Math.PI;
    }
    if (Function.named(name.text()).isPresent()) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_SYNTAX, name.offset(), name.text() + " lacks its arguments");
    }
    throw new ExpressionException(
        MessageCode.EXPRESSION_NAME,
        name.offset(),
        Quoted.of(name.text())
            + " stands for nothing here"
            + Nearest.suggestion(name.text(), List.of("PI")));
  }
}
