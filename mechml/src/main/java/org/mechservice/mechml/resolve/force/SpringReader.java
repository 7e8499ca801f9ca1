package org.mechservice.mechml.resolve.force;

import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.force.SpringDamper;

/** Reads {@code springDamper}. */
final class SpringReader {
  private final FormulaReader formulas;
  private final DampingReader dampers;
  private final MechanismNames names;
  private final Diagnostics diagnostics;

  SpringReader(FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.formulas = formulas;
    this.dampers = new DampingReader(formulas, diagnostics);
    this.names = names;
    this.diagnostics = diagnostics;
  }

  /** Returns the spring; empty after a reported error. */
  Optional<SpringDamper> read(Element element) {
    Optional<BodyPoint> point1 = names.point(element.requiredChild("body1"));
    Optional<BodyPoint> point2 = names.point(element.requiredChild("body2"));
    Optional<Expression> k = formulas.notNegative(element, "k", Quantity.STIFFNESS);
    Optional<DampingReader.Damping> c = dampers.read(element, DampingReader.SPRING, false);
    Optional<Expression> length0 = formulas.notNegative(element, "length0", Quantity.LENGTH);
    Optional<Expression> force0 = formulas.coefficient(element, "force0", Quantity.FORCE, 0);
    Optional<Expression> smoothing = formulas.notNegative(element, "smoothing", Quantity.LENGTH);
    Side side = side(element);
    boolean numbers = k.isPresent() && c.isPresent() && length0.isPresent();
    if (!isPossible(element, side)
        || point1.isEmpty()
        || point2.isEmpty()
        || !numbers
        || force0.isEmpty()
        || smoothing.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new SpringDamper(
            element.required("name"),
            point1.get(),
            point2.get(),
            k.get(),
            c.get().linear(),
            length0.get(),
            force0.get(),
            side,
            smoothing.get(),
            c.get().dissipation(),
            names.origin(element)));
  }

  private static Side side(Element element) {
    return switch (element.attribute("side").orElse("both")) {
      case "tension" -> Side.ABOVE;
      case "compression" -> Side.BELOW;
      default -> Side.BOTH;
    };
  }

  private boolean isPossible(Element element, Side side) {
    for (String attribute : List.of("smoothing", "restitution", "restitutionSpeed")) {
      if (side == Side.BOTH && element.attribute(attribute).isPresent()) {
        return refuse(
            element, attribute + " has no meaning for a spring that acts on both sides; add side");
      }
    }
    return side == Side.BOTH
        || element.attribute("force0").isEmpty()
        || refuse(element, "force0 has no meaning for a spring that acts on one side");
  }

  private boolean refuse(Element element, String message) {
    diagnostics.error(
        MessageCode.FORCE_ATTRIBUTES, element.position(), element.label() + ": " + message);
    return false;
  }
}
