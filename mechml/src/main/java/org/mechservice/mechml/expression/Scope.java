package org.mechservice.mechml.expression;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.symbol.MathFunction;

/** The values of the names in an expression. */
@FunctionalInterface
public interface Scope {
  /** The names every expression knows: {@code PI}, also written {@code Math.PI}. */
  Scope CONSTANTS = name -> constant(name, List.of());

  /**
   * Returns the value of a name.
   *
   * @throws ExpressionException if the name is unknown
   */
  double value(ParsedExpression.Reference name) throws ExpressionException;

  /**
   * Returns the value of a name that every expression knows.
   *
   * @param others the other names known here, for a suggestion
   * @throws ExpressionException if the name is none of them
   */
  static double constant(ParsedExpression.Reference name, Collection<String> others)
      throws ExpressionException {
    if (name.text().equals("PI") || name.text().equals("Math.PI")) {
      return Math.PI;
    }
    if (MathFunction.named(name.text()).isPresent()) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_SYNTAX, name.offset(), name.text() + " lacks its arguments");
    }
    List<String> known = new ArrayList<>(others);
    known.add("PI");
    throw new ExpressionException(
        MessageCode.EXPRESSION_NAME,
        name.offset(),
        Quoted.of(name.text())
            + " is not a known name here"
            + (name.text().equals("time")
                ? "; write time as t"
                : NearestName.suggestion(name.text(), known)));
  }
}
