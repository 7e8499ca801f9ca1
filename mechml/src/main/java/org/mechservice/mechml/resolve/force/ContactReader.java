package org.mechservice.mechml.resolve.force;

import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FormulaRole;
import org.mechservice.mechml.resolve.formula.FrameReader;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.force.Contact;

/** Reads {@code contact}: body1 carries the surface, body2 the sphere. */
final class ContactReader {
  private final ValueReader values;
  private final FormulaReader formulas;
  private final MechanismNames names;
  private final FrameReader frames;
  private final ProfileReader profiles;
  private final Diagnostics diagnostics;

  ContactReader(
      ValueReader values, FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.values = values;
    this.formulas = formulas;
    this.names = names;
    this.frames = new FrameReader(names, diagnostics);
    this.profiles = new ProfileReader(values, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Returns the contact; empty after a reported error. */
  Optional<Contact> read(Element element) {
    Element carrier = element.requiredChild("body1");
    boolean normal = frames.direction(carrier, "the normal of the surface").isPresent();
    Optional<BodyFrame> surface = normal ? frames.read(carrier) : Optional.empty();
    Optional<BodyPoint> center = names.point(element.requiredChild("body2"));
    Optional<Expression> radius = formulas.notNegative(element, "radius", Quantity.LENGTH);
    Optional<Expression> height = height(element, carrier);
    Optional<Expression> exponent = exponent(element);
    Optional<Expression> stiffness = exponent.flatMap(n -> stiffness(element, n));
    Optional<Expression> damping = formulas.notNegative(element, "damping", Quantity.DAMPING);
    Optional<Expression> smoothing = formulas.notNegative(element, "smoothing", Quantity.LENGTH);
    Optional<Expression> friction = formulas.notNegative(element, "friction", Quantity.NUMBER);
    Optional<Expression> speed = frictionSpeed(element);
    boolean shape = surface.isPresent() && center.isPresent() && height.isPresent();
    boolean push = stiffness.isPresent() && damping.isPresent() && smoothing.isPresent();
    boolean sliding = friction.isPresent() && speed.isPresent();
    if (!shape || !push || !sliding || radius.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new Contact(
            element.required("name"),
            center.get(),
            radius.get(),
            surface.get(),
            height.get(),
            stiffness.get(),
            damping.get(),
            exponent.orElseThrow(),
            smoothing.get(),
            friction.get(),
            speed.get(),
            names.origin(element)));
  }

  private Optional<Expression> exponent(Element element) {
    return formulas
        .coefficient(element, "exponent", Quantity.NUMBER, 1)
        .filter(n -> formulas.satisfies(element, "exponent", n, x -> x >= 1, "must be 1 or more"));
  }

  /** Returns k in N/mⁿ, from force per length to the power n in the file's units. */
  private Optional<Expression> stiffness(Element element, Expression exponent) {
    boolean linear = exponent.equals(Expression.of(1));
    if (!linear && element.attribute("stiffnessUnit").isPresent()) {
      error(
          element,
          MessageCode.FORCE_ATTRIBUTES,
          "stiffnessUnit can be given where exponent is 1 only; leave it out and write the"
              + " stiffness in the file's units of force and length");
      return Optional.empty();
    }
    Optional<Expression> k = formulas.positive(element, "stiffness", Quantity.STIFFNESS);
    double length = values.units().length().toSi(1);
    if (linear || length == 1) {
      return k;
    }
    // k/Lⁿ = k/L · L^(1 − n), L the file's unit of length
    Expression power =
        new Expression.Power(
            Expression.of(length),
            new Expression.Sum(Expression.of(1), new Expression.Negation(exponent)));
    return k.map(value -> new Expression.Product(value, power));
  }

  private Optional<Expression> frictionSpeed(Element element) {
    boolean needed =
        element.attribute("friction").isPresent() || element.attribute("frictionSpeed").isPresent();
    return needed
        ? formulas.positive(element, "frictionSpeed", Quantity.SPEED)
        : Optional.of(Expression.of(1));
  }

  private Optional<Expression> height(Element element, Element carrier) {
    Optional<Element> profile = element.child("profile");
    boolean formula = element.attribute("height").isPresent();
    if (!formula && profile.isEmpty()) {
      return Optional.of(Expression.ZERO);
    }
    if (formula && profile.isPresent()) {
      error(
          element,
          MessageCode.SURFACE_PROFILE,
          "height and <profile> define the same quantity; give only one");
      return Optional.empty();
    }
    if (carrier.attribute("vector2").isEmpty()) {
      error(
          element,
          MessageCode.SURFACE_PROFILE,
          "body1 needs vector2, the direction along which the height changes");
      return Optional.empty();
    }
    return formula
        ? formulas.read(element, "height", Quantity.LENGTH, FormulaRole.HEIGHT)
        : profiles.read(profile.orElseThrow());
  }

  private void error(Element element, MessageCode code, String message) {
    diagnostics.error(code, element.position(), element.label() + ": " + message);
  }
}
