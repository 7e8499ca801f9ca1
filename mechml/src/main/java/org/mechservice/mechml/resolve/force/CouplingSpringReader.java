package org.mechservice.mechml.resolve.force;

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
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.force.CouplingSpringDamper;

/**
 * Reads {@code couplingSpringDamper} and {@code elasticRope}. A coupling with backlash is two
 * springs, one for each flank.
 */
final class CouplingSpringReader {
  private final ValueReader values;
  private final FormulaReader formulas;
  private final DampingReader dampers;
  private final RelationReader relations;
  private final RopeReader ropes;
  private final MechanismNames names;
  private final Diagnostics diagnostics;

  CouplingSpringReader(
      ValueReader values, FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.values = values;
    this.formulas = formulas;
    this.dampers = new DampingReader(formulas, diagnostics);
    this.relations = new RelationReader(formulas, names, diagnostics);
    this.ropes = new RopeReader(values, formulas, names, diagnostics);
    this.names = names;
    this.diagnostics = diagnostics;
  }

  /** The coefficients of a spring and damper. */
  private record Law(
      Expression k, DampingReader.Damping c, Expression rest, Expression smoothing) {}

  private Optional<Law> law(Element element, String rest, boolean angle) {
    Optional<Expression> k =
        formulas.notNegative(
            element, "k", angle ? Quantity.TORSIONAL_STIFFNESS : Quantity.STIFFNESS);
    Optional<DampingReader.Damping> c = dampers.read(element, DampingReader.SPRING, angle);
    Quantity position = angle ? Quantity.ANGLE : Quantity.LENGTH;
    Optional<Expression> at = formulas.coefficient(element, rest, position, 0);
    Optional<Expression> smoothing = formulas.notNegative(element, "smoothing", position);
    return k.isPresent() && c.isPresent() && at.isPresent() && smoothing.isPresent()
        ? Optional.of(new Law(k.get(), c.get(), at.get(), smoothing.get()))
        : Optional.empty();
  }

  /** Returns the springs of a {@code couplingSpringDamper}; none after a reported error. */
  List<CouplingSpringDamper> read(Element element) {
    boolean angle = element.attribute("quantity").orElse("length").equals("angle");
    if (!relations.isComplete(element, "of positions") || !isPossible(element)) {
      return List.of();
    }
    Optional<Expression> along =
        relations.read(element, angle ? Unit.ONE : values.units().length());
    Optional<Law> law = law(element, "rest", angle);
    Quantity position = angle ? Quantity.ANGLE : Quantity.LENGTH;
    Quantity force = angle ? Quantity.TORQUE : Quantity.FORCE;
    Optional<Expression> force0 = formulas.coefficient(element, "force0", force, 0);
    Optional<Expression> backlash = formulas.notNegative(element, "backlash", position);
    if (along.isEmpty() || law.isEmpty() || force0.isEmpty() || backlash.isEmpty()) {
      return List.of();
    }
    String name = element.required("name");
    Spring spring =
        new Spring(element, along.get(), angle, law.get(), List.of(along.get()), List.of());
    if (element.attribute("backlash").isEmpty()) {
      return List.of(spring.of(name, side(element), law.get().rest(), force0.get()));
    }
    Expression half = new Expression.Product(Expression.of(0.5), backlash.get());
    Expression rest = law.get().rest();
    return List.of(
        spring.of(name + ".ahead", Side.ABOVE, plus(rest, half), Expression.ZERO),
        spring.of(
            name + ".behind",
            Side.BELOW,
            plus(rest, new Expression.Negation(half)),
            Expression.ZERO));
  }

  /** Returns the spring of an {@code elasticRope}; none after a reported error. */
  List<CouplingSpringDamper> rope(Element element) {
    Optional<RopeReader.Rope> rope = ropes.read(element);
    Optional<Law> law = law(element, "length0", false);
    if (rope.isEmpty() || law.isEmpty()) {
      return List.of();
    }
    Side side = element.attribute("side").isPresent() ? side(element) : Side.ABOVE;
    for (String attribute : List.of("smoothing", "restitution", "restitutionSpeed")) {
      if (side == Side.BOTH && element.attribute(attribute).isPresent()) {
        refuse(element, attribute + " has no meaning for side=\"both\"");
        return List.of();
      }
    }
    RopeReader.Rope path = rope.get();
    return List.of(
        new Spring(element, path.length(), false, law.get(), path.changes(), path.points())
            .of(element.required("name"), side, law.get().rest(), Expression.ZERO));
  }

  /** The attributes that all springs of an element share. */
  private final class Spring {
    private final Element element;
    private final Expression along;
    private final boolean angle;
    private final Law law;
    private final List<Expression> watched;
    private final List<BodyPoint> points;

    Spring(
        Element element,
        Expression along,
        boolean angle,
        Law law,
        List<Expression> watched,
        List<BodyPoint> points) {
      this.element = element;
      this.along = along;
      this.angle = angle;
      this.law = law;
      this.watched = watched;
      this.points = points;
    }

    CouplingSpringDamper of(String name, Side side, Expression rest, Expression force0) {
      return new CouplingSpringDamper(
          name,
          along,
          angle,
          law.k(),
          law.c().linear(),
          rest,
          force0,
          side,
          law.smoothing(),
          law.c().dissipation(),
          watched,
          points,
          names.origin(element));
    }
  }

  private static Expression plus(Expression left, Expression right) {
    return left.equals(Expression.ZERO) ? right : new Expression.Sum(left, right);
  }

  private static Side side(Element element) {
    return switch (element.attribute("side").orElse("both")) {
      case "tension" -> Side.ABOVE;
      case "compression" -> Side.BELOW;
      default -> Side.BOTH;
    };
  }

  private boolean isPossible(Element element) {
    boolean backlash = element.attribute("backlash").isPresent();
    boolean oneSided = side(element) != Side.BOTH;
    if (backlash && oneSided) {
      return refuse(element, "backlash and side exclude each other; teeth push on both flanks");
    }
    if ((backlash || oneSided) && element.attribute("force0").isPresent()) {
      return refuse(element, "force0 has no meaning for a spring that acts on one side");
    }
    for (String attribute : List.of("smoothing", "restitution", "restitutionSpeed")) {
      if (!backlash && !oneSided && element.attribute(attribute).isPresent()) {
        return refuse(
            element,
            attribute
                + " has no meaning for a spring that acts on both sides; add side or backlash");
      }
    }
    return true;
  }

  private boolean refuse(Element element, String message) {
    diagnostics.error(
        MessageCode.FORCE_ATTRIBUTES, element.position(), element.label() + ": " + message);
    return false;
  }
}
