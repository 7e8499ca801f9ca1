package org.mechservice.robot;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Coordinate;
import org.mechservice.robot.Robot.Freedom;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Mimic;
import org.mechservice.robot.Robot.Place;
import org.mechservice.robot.Robot.Range;
import org.mechservice.robot.Robot.Stop;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.Vector3;

/** Reads a joint of a robot. */
final class UrdfJointReader {
  private static final List<String> ONCE =
      List.of("origin", "parent", "child", "axis", "limit", "dynamics", "mimic");
  private static final List<String> TYPES =
      List.of("revolute", "continuous", "prismatic", "fixed", "floating", "planar");
  private static final Vector3 DEFAULT_AXIS = new Vector3(1, 0, 0);

  private final RobotNumbers numbers;
  private final Diagnostics diagnostics;
  private final ImportLosses losses;

  UrdfJointReader(RobotNumbers numbers, Diagnostics diagnostics, ImportLosses losses) {
    this.numbers = numbers;
    this.diagnostics = diagnostics;
    this.losses = losses;
  }

  /** Returns the joint unless it is in error. */
  Optional<Joint> read(Element element) {
    Optional<Freedom> type = type(element);
    Optional<String> parent = link(element, "parent");
    Optional<String> child = link(element, "child");
    if (type.isEmpty() || parent.isEmpty() || child.isEmpty()) {
      return Optional.empty();
    }
    numbers.requireOnce(element, ONCE);
    if (type.get() != Freedom.FIXED && !type.get().isSingle()) {
      loseAll(element, Set.of("limit", "dynamics", "mimic"));
    }
    return Optional.of(
        new Joint(
            element,
            element.required("name"),
            type.get(),
            parent.get(),
            child.get(),
            Place.at(numbers.origin(element), type.get().hasAxis() ? axis(element) : DEFAULT_AXIS),
            type.get().isSingle() ? coordinate(element, type.get()) : Coordinate.FREE));
  }

  private Coordinate coordinate(Element element, Freedom type) {
    Element dynamics = element.child("dynamics").orElse(element);
    return new Coordinate(
        limits(element, type),
        Stop.ASSUMED,
        0,
        0,
        notNegative(dynamics, "damping"),
        notNegative(dynamics, "friction"),
        0,
        element.child("mimic").flatMap(this::mimic));
  }

  private void loseAll(Element element, Set<String> names) {
    element.children().stream()
        .filter(part -> names.contains(part.name()))
        .filter(part -> !part.attributes().stream().allMatch(a -> a.value().matches("[0. ]*")))
        .forEach(
            part ->
                losses.motion(
                    part, "it is left out, because the joint has more than one coordinate"));
  }

  private Optional<Freedom> type(Element element) {
    Optional<String> name = element.attribute("type").map(String::strip);
    if (name.isEmpty()) {
      numbers.missing(element, "attribute type");
      return Optional.empty();
    }
    Optional<Freedom> known =
        name.filter(TYPES::contains).map(type -> Freedom.valueOf(type.toUpperCase(Locale.ROOT)));
    if (known.isEmpty()) {
      diagnostics.error(
          MessageCode.VALUE_NOT_IN_LIST,
          element.position(),
          Phrase.of(
              "%s: type is %s; a robot's joint is %s%s",
              element.label(),
              Quoted.of(name.get()),
              String.join(", ", TYPES),
              NearestName.suggestion(name.get(), TYPES)));
    }
    return known;
  }

  private Optional<String> link(Element element, String end) {
    Optional<Element> found = element.child(end);
    if (found.isEmpty()) {
      numbers.missing(element, end);
    }
    Optional<String> name = found.flatMap(e -> e.attribute("link"));
    if (found.isPresent() && name.isEmpty()) {
      numbers.missing(found.get(), "attribute link");
    }
    return name;
  }

  private Vector3 axis(Element element) {
    Optional<Element> found = element.child("axis");
    if (found.isEmpty()) {
      return DEFAULT_AXIS;
    }
    Vector3 axis = numbers.vector(found.get(), "xyz", DEFAULT_AXIS);
    if (!(axis.norm() > 0)) {
      diagnostics.error(
          MessageCode.ZERO_VECTOR,
          found.get().position(),
          Phrase.of("%s: it is zero and has no direction", found.get().label()));
      return DEFAULT_AXIS;
    }
    return axis.normalized();
  }

  private double notNegative(Element dynamics, String attribute) {
    double value = numbers.optional(dynamics, attribute, 0);
    if (value < 0) {
      diagnostics.error(
          MessageCode.ROBOT_JOINT,
          dynamics.position(),
          Phrase.of("%s: %s is %s; it must not be negative", dynamics.label(), attribute, value));
    }
    return value;
  }

  private Optional<Range> limits(Element joint, Freedom type) {
    Optional<Element> found = joint.child("limit");
    if (found.isEmpty()) {
      if (type != Freedom.CONTINUOUS) {
        numbers.missing(joint, "limit, which this joint type requires");
      }
      return Optional.empty();
    }
    Element limit = found.get();
    if (type == Freedom.CONTINUOUS) {
      return Optional.empty();
    }
    Range range =
        new Range(numbers.optional(limit, "lower", 0), numbers.optional(limit, "upper", 0));
    if (range.lower() > range.upper()) {
      diagnostics.error(
          MessageCode.ROBOT_JOINT,
          limit.position(),
          Phrase.of(
              "%s: lower is %s and upper %s; lower must not be above upper",
              limit.label(), range.lower(), range.upper()));
    }
    return Optional.of(range);
  }

  private Optional<Mimic> mimic(Element element) {
    Optional<String> other = element.attribute("joint");
    if (other.isEmpty()) {
      numbers.missing(element, "attribute joint");
    }
    return other.map(
        name ->
            new Mimic(
                element,
                name,
                numbers.optional(element, "multiplier", 1),
                numbers.optional(element, "offset", 0)));
  }
}
