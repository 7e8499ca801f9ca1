package org.mechservice.mechml.resolve.joint;

import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.formula.RelationReader;
import org.mechservice.mechml.resolve.formula.RopeReader;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;

/**
 * Reads {@code CoordConstraint}: an expression that must stay zero, or terms whose sum must stay
 * constant, Σ factor · q = constant; and {@code Rope}, whose length is constant.
 */
final class CouplingReader {
  private final FormulaReader formulas;
  private final RelationReader relations;
  private final RopeReader ropes;
  private final MechanismNames names;

  CouplingReader(
      ValueReader values, FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.formulas = formulas;
    this.relations = new RelationReader(formulas, names, diagnostics);
    this.ropes = new RopeReader(values, formulas, names, diagnostics);
    this.names = names;
  }

  /** Returns the coupling; empty after a reported error. */
  Optional<CoordinateClosure> read(Element element) {
    boolean expression = element.attribute("expression").isPresent();
    if (expression != element.children("term").isEmpty()
        || (expression && element.attribute("constant").isPresent())) {
      relations.report(
          element, "give either an expression that must stay zero, or terms with a constant");
      return Optional.empty();
    }
    Optional<Expression> relation =
        expression ? relations.read(element, Unit.ONE) : linear(element);
    return relation.map(
        r -> new CoordinateClosure(element.required("name"), r, List.of(), names.origin(element)));
  }

  private Optional<Expression> linear(Element element) {
    Optional<Expression> first =
        element.attribute("constant").isPresent()
            ? relations.factor(element, "constant").map(Expression.Negation::new)
            : Optional.of(Expression.ZERO);
    return first.flatMap(constant -> relations.sum(element, constant));
  }

  /** Returns the rope, whose length stays constant; empty after a reported error. */
  Optional<CoordinateClosure> rope(Element element) {
    Optional<RopeReader.Rope> rope = ropes.read(element);
    Optional<Expression> length = formulas.positive(element, "length", Quantity.LENGTH);
    return rope.flatMap(
        path ->
            length.map(
                given ->
                    new CoordinateClosure(
                        element.required("name"),
                        new Expression.Sum(path.length(), new Expression.Negation(given)),
                        path.points(),
                        names.origin(element))));
  }
}
