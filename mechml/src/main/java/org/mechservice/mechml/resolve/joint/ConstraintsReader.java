package org.mechservice.mechml.resolve.joint;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FrameReader;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.value.NameRule;
import org.mechservice.mechml.resolve.value.NameTable;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.KnifeEdgeClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.mechanism.closure.RollingClosure;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.Vector3;

/** Reads {@code Constraints}. */
public final class ConstraintsReader {
  private final ValueReader values;
  private final CouplingReader couplings;
  private final JointsReader joints;
  private final MechanismNames names;
  private final FrameReader frames;
  private final Diagnostics diagnostics;

  public ConstraintsReader(
      ValueReader values,
      FormulaReader formulas,
      JointsReader joints,
      MechanismNames names,
      Diagnostics diagnostics) {
    this.values = values;
    this.couplings = new CouplingReader(values, formulas, names, diagnostics);
    this.joints = joints;
    this.names = names;
    this.frames = new FrameReader(names, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Returns the constraints without errors, in file order. */
  public List<LoopClosure> read(Element model) {
    List<Element> elements = model.child("Constraints").map(Element::children).orElse(List.of());
    NameTable<Element> taken = new NameTable<>("constraint", "does not exist", diagnostics);
    List<LoopClosure> closures = new ArrayList<>();
    for (Element element : elements) {
      taken.add(element, Optional.of(element));
      closure(element).ifPresent(closures::add);
    }
    return closures;
  }

  private Optional<? extends LoopClosure> closure(Element element) {
    return switch (element.name()) {
      case "DISTConstraint" -> distance(element);
      case "CoordConstraint" -> couplings.read(element);
      case "Rope" -> couplings.rope(element);
      case "PointOnPlane" -> pointOnPlane(element);
      case "PointOnLine" -> pointOnLine(element);
      case "Rolling" -> rolling(element);
      case "KnifeEdge" -> knifeEdge(element);
      default -> jointConstraint(element);
    };
  }

  private Optional<DistanceClosure> distance(Element element) {
    Optional<BodyPoint> point1 = names.point(element.requiredChild("body1"));
    Optional<BodyPoint> point2 = names.point(element.requiredChild("body2"));
    OptionalDouble distance = values.quantity(element, "dist", Quantity.LENGTH);
    OptionalDouble mass = element.child("bodyrod").map(this::rodMass).orElse(OptionalDouble.of(0));
    if (distance.isPresent() && distance.getAsDouble() <= 0) {
      error(
          MessageCode.DISTANCE_NOT_POSITIVE,
          element,
          Phrase.of(
              "dist is %s m; it must be positive. For coinciding points write a joint of type S",
              distance.getAsDouble()));
      return Optional.empty();
    }
    if (!joinsTwoBodies(element, point1, point2) || distance.isEmpty() || mass.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new DistanceClosure(
            element.required("name"),
            point1.orElseThrow(),
            point2.orElseThrow(),
            distance.getAsDouble(),
            mass.getAsDouble(),
            names.origin(element)));
  }

  private OptionalDouble rodMass(Element rod) {
    NameRule.check(rod, diagnostics);
    OptionalDouble mass = values.quantity(rod, "mass", Quantity.MASS);
    if (mass.isPresent() && mass.getAsDouble() < 0) {
      error(
          MessageCode.NEGATIVE_MASS,
          rod,
          Phrase.of(
              "mass is negative: %s; write 0 for a rod without mass",
              Quoted.of(rod.required("mass"))));
      return OptionalDouble.empty();
    }
    return mass;
  }

  /** Returns whether there are two points, of two bodies; reports points of one body. */
  private boolean joinsTwoBodies(
      Element element, Optional<BodyPoint> point1, Optional<BodyPoint> point2) {
    if (point1.isEmpty() || point2.isEmpty()) {
      return false;
    }
    if (point1.get().body() == point2.get().body()) {
      error(
          MessageCode.JOINT_WITH_ITSELF,
          element,
          Phrase.of(
              "body1 and body2 are the same body, %s",
              Quoted.of(element.requiredChild("body1").required("name"))));
      return false;
    }
    return true;
  }

  private Optional<PointOnPlaneClosure> pointOnPlane(Element element) {
    Element carrier = element.requiredChild("body1");
    Optional<BodyPoint> plane = names.point(carrier);
    Optional<BodyPoint> point = names.point(element.requiredChild("body2"));
    Optional<Vector3> normal = frames.direction(carrier, "the normal of the plane");
    OptionalDouble offset = values.quantityOrZero(element, "offset", Quantity.LENGTH);
    if (!joinsTwoBodies(element, plane, point) || normal.isEmpty() || offset.isEmpty()) {
      return Optional.empty();
    }
    BodyPoint at = plane.orElseThrow();
    Vector3 shifted = at.position().plus(normal.get().times(offset.getAsDouble()));
    return Optional.of(
        new PointOnPlaneClosure(
            element.required("name"),
            point.orElseThrow(),
            offset.getAsDouble() == 0 ? at : new BodyPoint(at.body(), shifted),
            normal.get(),
            names.origin(element)));
  }

  private Optional<PointOnLineClosure> pointOnLine(Element element) {
    Element carrier = element.requiredChild("body1");
    Optional<BodyPoint> line = names.point(carrier);
    Optional<BodyPoint> point = names.point(element.requiredChild("body2"));
    Optional<Vector3> direction = frames.direction(carrier, "the direction of the line");
    return joinsTwoBodies(element, line, point) && direction.isPresent()
        ? Optional.of(
            new PointOnLineClosure(
                element.required("name"),
                point.orElseThrow(),
                line.orElseThrow(),
                direction.get(),
                names.origin(element)))
        : Optional.empty();
  }

  private Optional<RollingClosure> rolling(Element element) {
    Element carrier = element.requiredChild("body1");
    Element wheel = element.requiredChild("body2");
    Optional<BodyPoint> plane = names.point(carrier);
    Optional<BodyPoint> centre = names.point(wheel);
    Optional<Vector3> normal = frames.direction(carrier, "the normal of the plane");
    boolean isWheel = wheel.attribute("vector").isPresent();
    Optional<Vector3> axle =
        isWheel ? frames.direction(wheel, "the axle of the wheel") : Optional.of(Vector3.ZERO);
    OptionalDouble radius = values.quantity(element, "radius", Quantity.LENGTH);
    OptionalDouble tube = values.quantityOrZero(element, "tube", Quantity.LENGTH);
    boolean joins = joinsTwoBodies(element, plane, centre);
    if (radius.isPresent() && radius.getAsDouble() <= 0) {
      error(
          MessageCode.DISTANCE_NOT_POSITIVE,
          element,
          Phrase.of("radius is %s m; it must be positive", radius.getAsDouble()));
      return Optional.empty();
    }
    if (tube.isPresent() && (tube.getAsDouble() < 0 || (tube.getAsDouble() > 0 && !isWheel))) {
      error(
          MessageCode.DISTANCE_NOT_POSITIVE,
          element,
          isWheel
              ? Phrase.of("tube is %s m; it must not be negative", tube.getAsDouble())
              : "a ball has no tube; give body2 a vector, which is the axle of a wheel");
      return Optional.empty();
    }
    if (!joins || normal.isEmpty() || axle.isEmpty() || radius.isEmpty() || tube.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new RollingClosure(
            element.required("name"),
            plane.orElseThrow(),
            normal.get(),
            centre.orElseThrow(),
            axle.get(),
            radius.getAsDouble(),
            tube.getAsDouble(),
            names.origin(element)));
  }

  private Optional<KnifeEdgeClosure> knifeEdge(Element element) {
    Element edge = element.requiredChild("body2");
    Optional<BodyPoint> ground = names.point(element.requiredChild("body1"));
    Optional<BodyPoint> point = names.point(edge);
    Optional<Vector3> side = frames.direction(edge, "the direction across the edge");
    return joinsTwoBodies(element, ground, point) && side.isPresent()
        ? Optional.of(
            new KnifeEdgeClosure(
                element.required("name"),
                ground.orElseThrow(),
                point.orElseThrow(),
                side.get(),
                names.origin(element)))
        : Optional.empty();
  }

  private Optional<JointClosure> jointConstraint(Element element) {
    Optional<JointLink> link = joints.link(element, Optional.empty());
    if (link.isPresent() && link.get().body1() == link.get().body2()) {
      error(
          MessageCode.JOINT_WITH_ITSELF,
          element,
          Phrase.of(
              "body1 and body2 are the same body, %s",
              Quoted.of(element.requiredChild("body1").required("name"))));
      return Optional.empty();
    }
    return link.flatMap(JointLink::joint)
        .map(joint -> new JointClosure(joint, StartRole.FREE, List.of()));
  }

  private void error(MessageCode code, Element element, String message) {
    diagnostics.error(code, element.position(), element.label() + ": " + message);
  }
}
