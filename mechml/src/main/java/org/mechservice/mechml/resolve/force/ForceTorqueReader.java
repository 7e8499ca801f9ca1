package org.mechservice.mechml.resolve.force;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.body.BodyDefinition;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FormulaRole;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.value.AttributeText;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.force.ForceTorque;

/** Reads {@code forceTorque}. */
final class ForceTorqueReader {
  private final FormulaReader formulas;
  private final MechanismNames names;
  private final Diagnostics diagnostics;

  ForceTorqueReader(FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.formulas = formulas;
    this.names = names;
    this.diagnostics = diagnostics;
  }

  /** Returns the force; empty after a reported error. */
  Optional<ForceTorque> read(Element element) {
    Optional<BodyPoint> point = point(element);
    List<Expression> components = new ArrayList<>();
    for (String name : List.of("fx", "fy", "fz")) {
      component(element, name, "force", Quantity.FORCE).ifPresent(components::add);
    }
    for (String name : List.of("tx", "ty", "tz")) {
      component(element, name, "torque", Quantity.TORQUE).ifPresent(components::add);
    }
    if (point.isEmpty() || components.size() < 6) {
      return Optional.empty();
    }
    boolean body = element.attribute("frame").map("body"::equals).orElse(false);
    return Optional.of(
        new ForceTorque(
            element.required("name"),
            point.get(),
            body ? ForceTorque.Axes.BODY : ForceTorque.Axes.WORLD,
            components,
            names.origin(element)));
  }

  /**
   * The attribute {@code forceUnit} or {@code torqueUnit} holds the unit of all three components.
   */
  private Optional<Expression> component(
      Element element, String name, String kind, Quantity quantity) {
    Optional<Unit> unit = formulas.unit(element, kind, quantity);
    if (element.attribute(name).isEmpty()) {
      return unit.map(u -> Expression.ZERO);
    }
    return unit.flatMap(u -> formulas.read(AttributeText.of(element, name), u, FormulaRole.STATE));
  }

  private Optional<BodyPoint> point(Element element) {
    String name = element.required("body");
    Optional<BodyDefinition> body = names.body(name);
    if (body.isEmpty()) {
      diagnostics.error(
          MessageCode.UNKNOWN_NAME,
          element.position(),
          Phrase.of(
              "%s names body %s, which does not exist%s",
              element.label(), Quoted.of(name), NearestName.suggestion(name, names.bodyNames())));
    }
    return body.flatMap(parts -> point(element, parts));
  }

  private Optional<BodyPoint> point(Element element, BodyDefinition body) {
    String name = element.required("point");
    if (!body.points().names().contains(name)) {
      diagnostics.error(
          MessageCode.UNKNOWN_NAME,
          element.position(),
          Phrase.of(
              "%s names point %s, which body %s does not have%s",
              element.label(),
              Quoted.of(name),
              Quoted.of(body.name()),
              NearestName.suggestion(name, body.points().names())));
    }
    body.points().use(name);
    return body.points().value(name).map(position -> new BodyPoint(names.indexOf(body), position));
  }
}
