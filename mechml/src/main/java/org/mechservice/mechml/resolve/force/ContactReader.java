package org.mechservice.mechml.resolve.force;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.Road;
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
  private final FormulaReader formulas;
  private final MechanismNames names;
  private final FrameReader frames;
  private final ProfileReader profiles;
  private final ContactLawReader laws;
  private final Diagnostics diagnostics;

  ContactReader(
      ValueReader values, FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.laws = new ContactLawReader(values, formulas, diagnostics);
    this.formulas = formulas;
    this.names = names;
    this.frames = new FrameReader(names, diagnostics);
    this.profiles = new ProfileReader(values, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Returns the height of a surface over the plane of its carrier; empty after an error. */
  Optional<Expression> height(Element element) {
    return height(element, element.requiredChild("body1"));
  }

  /** Returns the surface with its height; empty after an error. */
  Optional<Road> road(Element element) {
    Optional<BodyFrame> frame = frames.read(element.requiredChild("body1"));
    return height(element).flatMap(height -> frame.map(axes -> new Road(axes, height)));
  }

  /** Returns the contact; empty after a reported error. */
  Optional<Contact> read(Element element) {
    Element carrier = element.requiredChild("body1");
    boolean normal = frames.direction(carrier, "the normal of the surface").isPresent();
    Optional<BodyFrame> surface = normal ? frames.read(carrier) : Optional.empty();
    Optional<BodyPoint> center = names.point(element.requiredChild("body2"));
    Optional<Expression> radius = formulas.notNegative(element, "radius", Quantity.LENGTH);
    Optional<Expression> height = height(element, carrier);
    Optional<Expression> exponent = laws.anyExponent(element);
    Optional<Expression> stiffness = exponent.flatMap(n -> laws.stiffness(element, n));
    Optional<DampingReader.Damping> damping = laws.damping(element);
    Optional<Expression> smoothing = formulas.notNegative(element, "smoothing", Quantity.LENGTH);
    Optional<Expression> friction = formulas.notNegative(element, "friction", Quantity.NUMBER);
    Optional<Expression> speed = laws.frictionSpeed(element);
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
            tracks(element, height.get(), radius.get()),
            stiffness.get(),
            damping.get().linear(),
            damping.get().dissipation(),
            exponent.orElseThrow(),
            smoothing.get(),
            friction.get(),
            speed.get(),
            names.origin(element)));
  }

  /** Returns the tracks of the centre; none where the closest point is sought on the height. */
  private static List<Expression> tracks(Element element, Expression height, Expression radius) {
    boolean sphere = radius instanceof Expression.Constant number && number.value() > 0;
    if (!sphere) {
      return List.of();
    }
    List<Expression> tracks = new ArrayList<>();
    double size = ((Expression.Constant) radius).value();
    HeightPieces.of(height)
        .map(pieces -> SphereTracks.of(pieces, size))
        .orElse(List.of())
        .forEach(
            track ->
                tracks.add(
                    new Expression.TableValue(
                        track.table(element.required("name") + ".track" + (tracks.size() + 1)),
                        List.of(new Expression.Argument()))));
    return tracks;
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
