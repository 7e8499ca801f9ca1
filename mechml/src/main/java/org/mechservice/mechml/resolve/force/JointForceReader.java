package org.mechservice.mechml.resolve.force;

import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.CoordinateReader;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FormulaRole;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.formula.ResolvedCoordinate;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.force.JointFriction;
import org.mechservice.solver.mechanism.force.JointSpringDamper;

/** Reads the forces that act on a coordinate of a joint. */
final class JointForceReader {
  private final FormulaReader formulas;
  private final CoordinateReader coordinates;
  private final MechanismNames names;
  private final Diagnostics diagnostics;

  JointForceReader(FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.formulas = formulas;
    this.coordinates = new CoordinateReader(names, diagnostics);
    this.names = names;
    this.diagnostics = diagnostics;
  }

  /** Reads {@code torsionSpringDamper}; empty after a reported error. */
  Optional<JointSpringDamper> torsionSpringDamper(Element element) {
    Optional<ResolvedCoordinate> place = coordinates.position(element);
    Optional<Expression> k = formulas.notNegative(element, "k", Quantity.TORSIONAL_STIFFNESS);
    Optional<Expression> c = formulas.notNegative(element, "c", Quantity.TORSIONAL_DAMPING);
    Optional<Expression> angle0 = formulas.coefficient(element, "angle0", Quantity.ANGLE, 0);
    if (place.isPresent() && !place.get().turns()) {
      diagnostics.error(
          MessageCode.FORCE_ATTRIBUTES,
          element.position(),
          element.label()
              + ": this coordinate is a displacement; give the joint the attributes stiffness and"
              + " damping instead");
      return Optional.empty();
    }
    if (place.isEmpty() || k.isEmpty() || c.isEmpty() || angle0.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new JointSpringDamper(
            element.required("name"),
            place.get().coordinate(),
            k.get(),
            c.get(),
            angle0.get(),
            Expression.ZERO,
            Side.BOTH,
            Expression.ZERO,
            names.origin(element)));
  }

  /** Reads {@code jointForce}; empty after a reported error. */
  Optional<JointForce> jointForce(Element element) {
    Optional<ResolvedCoordinate> place = coordinates.velocity(element);
    if (place.isEmpty()) {
      return Optional.empty();
    }
    Quantity quantity = place.get().turns() ? Quantity.TORQUE : Quantity.FORCE;
    return formulas
        .read(element, "expression", quantity, FormulaRole.STATE)
        .map(
            force ->
                new JointForce(
                    element.required("name"),
                    place.get().coordinate(),
                    force,
                    names.origin(element)));
  }

  /** Reads {@code friction}; empty after a reported error. */
  Optional<JointFriction> friction(Element element) {
    Optional<ResolvedCoordinate> place = coordinates.velocity(element);
    if (place.isEmpty()) {
      return Optional.empty();
    }
    boolean turns = place.get().turns();
    Optional<Expression> coulomb =
        formulas.notNegative(element, "coulomb", turns ? Quantity.TORQUE : Quantity.FORCE);
    Optional<Expression> viscous =
        formulas.notNegative(
            element, "viscous", turns ? Quantity.TORSIONAL_DAMPING : Quantity.DAMPING);
    boolean dry = element.attribute("coulomb").isPresent();
    Optional<Expression> speed =
        dry || element.attribute("speed").isPresent()
            ? formulas.positive(element, "speed", turns ? Quantity.ANGULAR_SPEED : Quantity.SPEED)
            : Optional.of(Expression.of(1));
    if (coulomb.isEmpty() || viscous.isEmpty() || speed.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new JointFriction(
            element.required("name"),
            place.get().coordinate(),
            coulomb.get(),
            viscous.get(),
            speed.get(),
            names.origin(element)));
  }
}
