package org.mechservice.mechml.resolve.force;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.formula.ResolvedJoint;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointFriction;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.LawForce;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.spatial.Rotation;

/**
 * Reads the forces given as attributes of joints: spring, damper, friction, stops. The forces are
 * named after the joint: {@code knee.spring}, {@code knee.friction}, {@code knee.lower}, {@code
 * knee.upper}, followed by the component index if the joint has several coordinates.
 */
public final class JointAttributesReader {
  private static final List<String> SPRING = List.of("stiffness", "damping", "freePosition");
  private static final List<String> NOT_OF_BALLS =
      List.of("stiffness", "freePosition", "lower", "upper", "stopStiffness");
  private static final List<String> FRICTION = List.of("friction", "frictionSpeed");
  private static final List<String> STOPS =
      List.of(
          "lower",
          "upper",
          "stopStiffness",
          "stopDamping",
          "stopRestitution",
          "stopRestitutionSpeed",
          "stopSmoothing");

  private final FormulaReader formulas;
  private final DampingReader dampers;
  private final MechanismNames names;
  private final Diagnostics diagnostics;

  public JointAttributesReader(
      FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.formulas = formulas;
    this.dampers = new DampingReader(formulas, diagnostics);
    this.names = names;
    this.diagnostics = diagnostics;
  }

  /**
   * Returns the forces of a joint that are without errors.
   *
   * @param place where it joins its bodies; empty after a reported error
   */
  public List<ForceElement> read(ResolvedJoint joint, Optional<Attachment> place) {
    Element element = joint.element();
    boolean spring = hasAny(element, SPRING);
    boolean friction = hasAny(element, FRICTION);
    boolean stops = hasAny(element, STOPS);
    List<ForceElement> forces = new ArrayList<>();
    if (joint.type() == JointType.S && (spring || friction) && !hasAny(element, NOT_OF_BALLS)) {
      place.flatMap(at -> rotation(element, at)).ifPresent(forces::add);
      return forces;
    }
    if ((spring || friction || stops) && takesForces(joint)) {
      List<CoordinateValues> values = components(joint);
      if (spring) {
        values.forEach(v -> spring(v).ifPresent(forces::add));
      }
      if (friction && isGiven(element, "friction", "frictionSpeed")) {
        values.forEach(v -> friction(v).ifPresent(forces::add));
      }
      if (stops && isStopped(element)) {
        values.forEach(v -> stops(v, forces));
      }
    }
    return forces;
  }

  /** Returns the damping and friction of a ball, against its whole angular velocity. */
  private Optional<LawForce> rotation(Element element, Attachment at) {
    boolean rubs = isGiven(element, "friction", "frictionSpeed");
    if (!rubs && hasAny(element, FRICTION)) {
      return Optional.empty();
    }
    Optional<Expression> damping =
        formulas.notNegative(element, "damping", Quantity.TORSIONAL_DAMPING);
    Optional<Expression> friction = formulas.notNegative(element, "friction", Quantity.TORQUE);
    Optional<Expression> speed =
        rubs
            ? formulas.positive(element, "frictionSpeed", Quantity.ANGULAR_SPEED)
            : Optional.of(new Expression.Constant(1));
    if (damping.isEmpty() || friction.isEmpty() || speed.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new LawForce(
            element.required("name") + ".friction",
            PairLaw.ROTATION_FRICTION,
            new BodyFrame(at.parent(), at.parentPoint(), Rotation.IDENTITY),
            new BodyFrame(at.child(), at.childPoint(), Rotation.IDENTITY),
            List.of(damping.get(), friction.get(), speed.get()),
            names.origin(element)));
  }

  private static boolean hasAny(Element element, List<String> attributes) {
    return attributes.stream().anyMatch(a -> element.attribute(a).isPresent());
  }

  private boolean takesForces(ResolvedJoint joint) {
    JointType type = joint.type();
    if (type == JointType.S || type == JointType.F || type == JointType.W) {
      error(
          joint.element(),
          Phrase.of(
              "a joint of type %s has no %s; use a bushing between its bodies",
              type, type == JointType.S ? "springs or stops" : "springs, friction or stops"));
      return false;
    }
    return true;
  }

  private boolean isGiven(Element element, String attribute, String needed) {
    boolean given = element.attribute(attribute).isPresent();
    if (given != element.attribute(needed).isPresent()) {
      error(
          element,
          Phrase.of(
              "%s needs %s",
              given ? attribute : needed,
              given ? needed + " beside it" : attribute + " beside it"));
      return false;
    }
    return given;
  }

  private boolean isStopped(Element element) {
    boolean bound =
        element.attribute("lower").isPresent() || element.attribute("upper").isPresent();
    if (bound && element.attribute("stopStiffness").isPresent()) {
      return true;
    }
    error(
        element,
        bound
            ? "lower and upper are stops and need a stopStiffness"
            : "stopStiffness, stopDamping, stopRestitution and stopSmoothing need a lower or an"
                + " upper stop");
    return false;
  }

  private List<CoordinateValues> components(ResolvedJoint joint) {
    List<CoordinateValues> components = new ArrayList<>();
    for (int i = 0; i < joint.type().velocityCount(); i++) {
      components.add(new CoordinateValues(joint, i, formulas));
    }
    return components;
  }

  private Optional<JointSpringDamper> spring(CoordinateValues values) {
    Optional<Expression> k = values.notNegative("stiffness", values.stiffness());
    Optional<Expression> c = values.notNegative("damping", values.damping());
    Optional<Expression> free = values.coefficient("freePosition", values.position());
    if (k.isEmpty() || c.isEmpty() || free.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new JointSpringDamper(
            values.name("spring"),
            values.coordinate(),
            k.get(),
            c.get(),
            free.get(),
            Expression.ZERO,
            Side.BOTH,
            Expression.ZERO,
            names.origin(values.element())));
  }

  private Optional<JointFriction> friction(CoordinateValues values) {
    Optional<Expression> coulomb = values.notNegative("friction", values.force());
    Optional<Expression> speed = values.positive("frictionSpeed", values.velocity());
    if (coulomb.isEmpty() || speed.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new JointFriction(
            values.name("friction"),
            values.coordinate(),
            coulomb.get(),
            Expression.ZERO,
            speed.get(),
            names.origin(values.element())));
  }

  private void stops(CoordinateValues values, List<ForceElement> forces) {
    Optional<Expression> lower = values.coefficient("lower", values.position());
    Optional<Expression> upper = values.coefficient("upper", values.position());
    if (lower.isPresent()
        && upper.isPresent()
        && crossed(values.element(), lower.get(), upper.get())) {
      error(values.element(), "the lower stop is above the upper one");
      return;
    }
    lower.flatMap(at -> stop(values, "lower", at, Side.BELOW)).ifPresent(forces::add);
    upper.flatMap(at -> stop(values, "upper", at, Side.ABOVE)).ifPresent(forces::add);
  }

  private static boolean crossed(Element element, Expression lower, Expression upper) {
    return hasAny(element, List.of("lower"))
        && hasAny(element, List.of("upper"))
        && lower instanceof Expression.Constant low
        && upper instanceof Expression.Constant high
        && low.value() > high.value();
  }

  private Optional<JointSpringDamper> stop(
      CoordinateValues values, String attribute, Expression at, Side side) {
    Optional<Expression> k = values.positive("stopStiffness", values.stiffness());
    Optional<DampingReader.Damping> c =
        dampers.read(values.element(), DampingReader.STOP, values.turns(), values::coefficient);
    Optional<Expression> smoothing = values.notNegative("stopSmoothing", values.position());
    boolean given = values.element().attribute(attribute).isPresent();
    if (!given || k.isEmpty() || c.isEmpty() || smoothing.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new JointSpringDamper(
            values.name(attribute),
            values.coordinate(),
            k.get(),
            c.get().linear(),
            at,
            Expression.ZERO,
            side,
            smoothing.get(),
            c.get().dissipation(),
            names.origin(values.element())));
  }

  private void error(Element element, String message) {
    diagnostics.error(
        MessageCode.FORCE_ATTRIBUTES, element.position(), element.label() + ": " + message);
  }

  /**
   * The attribute values of one coordinate of a joint; each attribute is a list with one item per
   * coordinate.
   *
   * @param joint a joint whose velocities are the rates of its positions
   * @param component the coordinate, from 0
   * @param formulas reads the items
   */
  private record CoordinateValues(ResolvedJoint joint, int component, FormulaReader formulas) {

    Element element() {
      return joint.element();
    }

    Coordinate coordinate() {
      return joint.coordinate(component);
    }

    /** Returns the name of the coordinate's force of the given kind. */
    String name(String kind) {
      String name = element().required("name") + "." + kind;
      return joint.type().velocityCount() == 1 ? name : name + "[" + component + "]";
    }

    Quantity position() {
      return turns() ? Quantity.ANGLE : Quantity.LENGTH;
    }

    Quantity velocity() {
      return turns() ? Quantity.ANGULAR_SPEED : Quantity.SPEED;
    }

    Quantity force() {
      return turns() ? Quantity.TORQUE : Quantity.FORCE;
    }

    Quantity stiffness() {
      return turns() ? Quantity.TORSIONAL_STIFFNESS : Quantity.STIFFNESS;
    }

    Quantity damping() {
      return turns() ? Quantity.TORSIONAL_DAMPING : Quantity.DAMPING;
    }

    private boolean turns() {
      return joint.turns(component);
    }

    /** Returns the coordinate's item of an attribute, zero if the attribute is missing. */
    Optional<Expression> coefficient(String attribute, Quantity quantity) {
      return formulas.item(element(), attribute, joint.type().velocityCount(), component, quantity);
    }

    Optional<Expression> notNegative(String attribute, Quantity quantity) {
      return coefficient(attribute, quantity)
          .filter(
              c ->
                  formulas.satisfies(element(), attribute, c, x -> x >= 0, "must not be negative"));
    }

    Optional<Expression> positive(String attribute, Quantity quantity) {
      return coefficient(attribute, quantity)
          .filter(c -> formulas.satisfies(element(), attribute, c, x -> x > 0, "must be positive"));
    }
  }
}
