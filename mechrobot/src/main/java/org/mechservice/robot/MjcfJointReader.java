package org.mechservice.robot;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Coordinate;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.robot.Robot.Freedom;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Place;
import org.mechservice.robot.Robot.Range;
import org.mechservice.robot.Robot.Stop;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads the joints of MJCF: what they let move, about which axis through which point, and what acts
 * along their coordinate. Source: MuJoCo documentation, XML reference, {@code joint}.
 */
final class MjcfJointReader {
  private static final Vector3 Z = new Vector3(0, 0, 1);

  /** MuJoCo's time constant and damping ratio of stops. */
  static final List<Double> SOLREF = List.of(0.02, 1.0);

  private final MjcfCompiler compiler;
  private final MjcfOptions options;
  private final RobotNumbers numbers;
  private final Diagnostics diagnostics;
  private final ImportLosses losses;

  MjcfJointReader(
      MjcfCompiler compiler,
      MjcfOptions options,
      RobotNumbers numbers,
      Diagnostics diagnostics,
      ImportLosses losses) {
    this.compiler = compiler;
    this.options = options;
    this.numbers = numbers;
    this.diagnostics = diagnostics;
    this.losses = losses;
  }

  /**
   * Returns a joint; one of an unknown type is reported and read as a hinge.
   *
   * @param name of the joint in the robot
   * @param held the frame in the body that the joint's place is in
   * @param frame of the child in the parent, where the joint's coordinate is zero
   */
  Joint read(Element element, Frame held, String name, String parent, String child, Frame frame) {
    String type =
        element.name().equals("freejoint") ? "free" : element.attribute("type").orElse("hinge");
    Freedom freedom =
        switch (type) {
          case "free" -> Freedom.FLOATING;
          case "ball" -> Freedom.SPHERICAL;
          case "slide" -> Freedom.PRISMATIC;
          default -> Freedom.REVOLUTE;
        };
    if (!Set.of("free", "ball", "slide", "hinge").contains(type)) {
      diagnostics.error(
          MessageCode.VALUE_NOT_IN_LIST,
          element.position(),
          Phrase.of(
              "%s: type is %s; a joint of MJCF is free, ball, slide, hinge",
              element.label(), Quoted.of(type)));
    }
    Vector3 point =
        freedom == Freedom.FLOATING
            ? Vector3.ZERO
            : held.at().plus(held.turn().apply(numbers.vector(element, "pos", Vector3.ZERO)));
    Vector3 axis = held.turn().apply(axis(element));
    return new Joint(
        element,
        name,
        freedom,
        parent,
        child,
        Place.along(frame, point, axis),
        coordinate(element, freedom));
  }

  private Vector3 axis(Element element) {
    Vector3 axis = numbers.vector(element, "axis", Z);
    if (!(axis.norm() > 0)) {
      diagnostics.error(
          MessageCode.ZERO_VECTOR,
          element.position(),
          Phrase.of("%s: its axis is zero and has no direction", element.label()));
      return Z;
    }
    return axis.normalized();
  }

  /** Returns a number, the first of a polynomial; higher powers are reported. */
  private double first(Element element, String name) {
    Optional<List<Double>> read =
        element.attribute(name).map(text -> numbers.read(element, name, text, 1, 8));
    if (read.isPresent() && read.get().stream().skip(1).anyMatch(x -> x != 0)) {
      losses.motion(element, "the higher powers of " + name + " are left out");
    }
    return read.map(list -> list.get(0)).orElse(0.0);
  }

  private boolean isLimited(Element element) {
    String limited = element.attribute("limited").orElse("auto");
    return options.limits()
        && (limited.equals("true")
            || (limited.equals("auto")
                && compiler.autolimits()
                && element.attribute("range").isPresent()));
  }

  /** Returns the reference of a joint's position: what the file's pose counts as, rad or m. */
  double reference(Element element, Freedom freedom) {
    double unit = freedom == Freedom.PRISMATIC ? 1 : compiler.angle();
    return freedom.isSingle() ? numbers.optional(element, "ref", 0) * unit : 0;
  }

  private Coordinate coordinate(Element element, Freedom freedom) {
    double stiffness = options.springs() ? first(element, "stiffness") : 0;
    double damping = options.dampers() ? first(element, "damping") : 0;
    double friction = options.friction() ? numbers.optional(element, "frictionloss", 0) : 0;
    double armature = numbers.optional(element, "armature", 0);
    if (friction < 0) {
      numbers.contradiction(element, "frictionloss is " + friction + "; it must not be negative");
    }
    if (armature < 0) {
      numbers.contradiction(element, "armature is " + armature + "; it must not be negative");
    }
    if (!freedom.isSingle()) {
      if (friction != 0) {
        losses.motion(
            element,
            freedom == Freedom.FLOATING
                ? "frictionloss of a free joint is left out"
                : "frictionloss acts against the whole rotation here, and along each of three axes"
                    + " in MuJoCo");
      }
      if (isLimited(element)) {
        losses.motion(element, "the range of a " + name(freedom) + " joint is left out");
      }
      Coordinate all = Coordinate.FREE.with(stiffness, damping).armed(armature);
      return freedom == Freedom.SPHERICAL ? all.rubbing(friction) : all;
    }
    double unit = freedom == Freedom.PRISMATIC ? 1 : compiler.angle();
    double reference = reference(element, freedom);
    if (reference != 0) {
      losses.picture(element, "ref is left out: the position counts from the pose of the file");
    }
    Optional<Range> limits = Optional.empty();
    if (isLimited(element)) {
      List<Double> ends =
          element
              .attribute("range")
              .map(text -> numbers.read(element, "range", text, 2, 2))
              .orElse(List.of(0.0, 0.0));
      if (!(ends.get(0) < ends.get(1))) {
        numbers.contradiction(element, "its range is empty; write the lower end first");
      }
      limits =
          Optional.of(new Range(ends.get(0) * unit - reference, ends.get(1) * unit - reference));
    }
    return new Coordinate(
        limits,
        stop(element),
        stiffness,
        numbers.optional(element, "springref", 0) * unit - reference,
        damping,
        friction,
        armature,
        Optional.empty());
  }

  private static String name(Freedom freedom) {
    return freedom == Freedom.FLOATING ? "free" : "ball";
  }

  /** MuJoCo's stops have a time constant and a damping ratio, or stiffness and damping. */
  private Stop stop(Element element) {
    List<Double> given =
        element
            .attribute("solreflimit")
            .map(text -> numbers.read(element, "solreflimit", text, 2, 2))
            .orElse(SOLREF);
    return Stop.of(given.get(0), given.get(1));
  }
}
