package org.mechservice.mechml.resolve.formula;

import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.AttributeText;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;

/**
 * Reads what couples positions: an attribute {@code expression}, or elements {@code term} whose sum
 * is Σ factor · q. In both, lengths are in the file's unit and angles in rad.
 */
public final class RelationReader {
  private final FormulaReader formulas;
  private final CoordinateReader coordinates;
  private final Diagnostics diagnostics;

  public RelationReader(FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.formulas = formulas;
    this.coordinates = new CoordinateReader(names, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Returns whether an element has either an expression or terms; reports it if not. */
  public boolean isComplete(Element element, String wanted) {
    boolean expression = element.attribute("expression").isPresent();
    if (expression == element.children("term").isEmpty()) {
      return true;
    }
    report(element, "give either an expression " + wanted + ", or terms");
    return false;
  }

  /** Reports what an element lacks. */
  public void report(Element element, String message) {
    diagnostics.error(
        MessageCode.COUPLING_INCOMPLETE, element.position(), element.label() + ": " + message);
  }

  /** Returns the value of the expression, or the sum of the terms, in a unit. */
  public Optional<Expression> read(Element element, Unit unit) {
    return element.attribute("expression").isPresent()
        ? formulas.read(AttributeText.of(element, "expression"), unit, FormulaRole.RELATION)
        : sum(element, Expression.ZERO).map(sum -> FormulaNames.toSi(sum, unit));
  }

  /**
   * Returns the sum of the terms of an element, in the file's units.
   *
   * @param first what it begins with
   */
  public Optional<Expression> sum(Element element, Expression first) {
    Optional<Expression> sum = Optional.of(first);
    for (Element term : element.children("term")) {
      Optional<Expression> product = product(term);
      sum = sum.flatMap(left -> product.map(right -> plus(left, right)));
    }
    return sum;
  }

  static Expression plus(Expression left, Expression right) {
    return left.equals(Expression.ZERO) ? right : new Expression.Sum(left, right);
  }

  private Optional<Expression> product(Element term) {
    Optional<Expression> factor = factor(term, "factor");
    Optional<Expression> position =
        coordinates.position(term).map(place -> formulas.inFileUnits(place));
    return factor.flatMap(f -> position.map(p -> new Expression.Product(f, p)));
  }

  /** Returns a number by which positions are multiplied or that their sum has. */
  public Optional<Expression> factor(Element element, String attribute) {
    return formulas.read(AttributeText.of(element, attribute), Unit.ONE, FormulaRole.COEFFICIENT);
  }
}
