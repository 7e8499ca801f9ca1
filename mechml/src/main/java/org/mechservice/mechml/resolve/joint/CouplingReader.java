package org.mechservice.mechml.resolve.joint;

import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.CoordinateReader;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FormulaRole;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.value.AttributeText;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;

/**
 * Reads {@code CoordConstraint}: an expression that must stay zero, or terms whose sum must stay
 * constant, Σ factor · q = constant. In both, lengths are in the file's unit and angles in rad.
 */
final class CouplingReader {
  private final FormulaReader formulas;
  private final CoordinateReader coordinates;
  private final MechanismNames names;
  private final Diagnostics diagnostics;

  CouplingReader(FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.formulas = formulas;
    this.coordinates = new CoordinateReader(names, diagnostics);
    this.names = names;
    this.diagnostics = diagnostics;
  }

  /** Returns the coupling; empty after a reported error. */
  Optional<CoordinateClosure> read(Element element) {
    List<Element> terms = element.children("term");
    boolean expression = element.attribute("expression").isPresent();
    if (expression != terms.isEmpty()
        || (expression && element.attribute("constant").isPresent())) {
      diagnostics.error(
          MessageCode.COUPLING_INCOMPLETE,
          element.position(),
          element.label()
              + ": give either an expression that must stay zero, or terms with a constant");
      return Optional.empty();
    }
    Optional<Expression> relation = expression ? expression(element) : linear(element, terms);
    return relation.map(
        r -> new CoordinateClosure(element.required("name"), r, names.origin(element)));
  }

  private Optional<Expression> expression(Element element) {
    return formulas.read(AttributeText.of(element, "expression"), Unit.ONE, FormulaRole.RELATION);
  }

  private Optional<Expression> linear(Element element, List<Element> terms) {
    Optional<Expression> sum =
        element.attribute("constant").isPresent()
            ? factor(element, "constant").map(Expression.Negation::new)
            : Optional.of(Expression.ZERO);
    for (Element term : terms) {
      Optional<Expression> product = product(term);
      sum = sum.flatMap(left -> product.map(right -> plus(left, right)));
    }
    return sum;
  }

  private static Expression plus(Expression left, Expression right) {
    return left.equals(Expression.ZERO) ? right : new Expression.Sum(left, right);
  }

  private Optional<Expression> product(Element term) {
    Optional<Expression> factor = factor(term, "factor");
    Optional<Expression> position =
        coordinates.position(term).map(place -> formulas.inFileUnits(place));
    return factor.flatMap(f -> position.map(p -> new Expression.Product(f, p)));
  }

  private Optional<Expression> factor(Element element, String attribute) {
    return formulas.read(AttributeText.of(element, attribute), Unit.ONE, FormulaRole.COEFFICIENT);
  }
}
