package org.mechservice.robot;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
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
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads the joints of MJCF: what they let move, about which axis through which point, and what acts
 * along their coordinate. Source: MuJoCo documentation, XML reference, {@code joint}.
 */
final class MjcfJointReader {
  private static final Vector3 Z = new Vector3(0, 0, 1);

  /**
   * A joint that stands in a body.
   *
   * @param frame the frame in the body that its pose is in
   * @param attribute gives the text of an attribute, with its default
   */
  record Held(Element element, Frame frame, Function<String, Optional<String>> attribute) {}

  private final MjcfCompiler compiler;
  private final RobotNumbers numbers;
  private final Diagnostics diagnostics;
  private final ImportLosses losses;

  MjcfJointReader(
      MjcfCompiler compiler, RobotNumbers numbers, Diagnostics diagnostics, ImportLosses losses) {
    this.compiler = compiler;
    this.numbers = numbers;
    this.diagnostics = diagnostics;
    this.losses = losses;
  }

  /**
   * Returns a joint; one of an unknown type is reported and read as a hinge.
   *
   * @param name of the joint in the robot
   * @param frame of the child in the parent, where the joint's coordinate is zero
   */
  Joint read(Held held, String name, String parent, String child, Frame frame) {
    Element element = held.element();
    Function<String, Optional<String>> attribute = held.attribute();
    String type =
        element.name().equals("freejoint") ? "free" : attribute.apply("type").orElse("hinge");
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
    loseMotor(element, attribute, freedom);
    Vector3 point =
        freedom == Freedom.FLOATING
            ? Vector3.ZERO
            : held.frame().times(compiler.frame(element, position(attribute))).at();
    Vector3 axis = held.frame().turn().apply(axis(element, attribute));
    return new Joint(
        element,
        name,
        freedom,
        parent,
        child,
        Place.along(frame, point, axis),
        freedom.isSingle() ? coordinate(element, attribute, freedom) : Coordinate.FREE);
  }

  private static Function<String, Optional<String>> position(
      Function<String, Optional<String>> attribute) {
    return name -> name.equals("pos") ? attribute.apply(name) : Optional.empty();
  }

  private Vector3 axis(Element element, Function<String, Optional<String>> attribute) {
    List<Double> xyz =
        attribute
            .apply("axis")
            .map(text -> numbers.read(element, "axis", text, 3, 3))
            .orElse(List.of(0.0, 0.0, 1.0));
    Vector3 axis = new Vector3(xyz.get(0), xyz.get(1), xyz.get(2));
    if (!(axis.norm() > 0)) {
      diagnostics.error(
          MessageCode.ZERO_VECTOR,
          element.position(),
          Phrase.of("%s: its axis is zero and has no direction", element.label()));
      return Z;
    }
    return axis.normalized();
  }

  private void loseMotor(
      Element element, Function<String, Optional<String>> attribute, Freedom freedom) {
    if (number(element, attribute, "armature", 0) != 0) {
      losses.add(element, "armature, the inertia of its motor, is left out");
    }
    if (!freedom.isSingle()) {
      for (String name : List.of("stiffness", "damping", "frictionloss")) {
        if (number(element, attribute, name, 0) != 0) {
          losses.add(element, name + " applies only to joints with one coordinate here");
        }
      }
    }
  }

  private double number(
      Element element,
      Function<String, Optional<String>> attribute,
      String name,
      double otherwise) {
    Optional<List<Double>> read =
        attribute.apply(name).map(text -> numbers.read(element, name, text, 1, 3));
    if (read.isPresent() && read.get().stream().skip(1).anyMatch(x -> x != 0)) {
      losses.add(element, "the higher powers of " + name + " are left out");
    }
    return read.map(list -> list.get(0)).orElse(otherwise);
  }

  private Coordinate coordinate(
      Element element, Function<String, Optional<String>> attribute, Freedom freedom) {
    double unit = freedom == Freedom.PRISMATIC ? 1 : compiler.angle();
    double reference = number(element, attribute, "ref", 0) * unit;
    if (reference != 0) {
      losses.add(element, "ref is left out: the position counts from the pose of the file");
    }
    Optional<Range> limits = Optional.empty();
    Optional<String> range = attribute.apply("range");
    String limited = attribute.apply("limited").orElse("auto");
    if (limited.equals("true")
        || (limited.equals("auto") && compiler.autolimits() && range.isPresent())) {
      List<Double> ends =
          range.map(text -> numbers.read(element, "range", text, 2, 2)).orElse(List.of(0.0, 0.0));
      if (ends.get(0) > ends.get(1)) {
        numbers.contradiction(element, "its range is reversed; write the lower end first");
      }
      limits =
          Optional.of(new Range(ends.get(0) * unit - reference, ends.get(1) * unit - reference));
    }
    return new Coordinate(
        limits,
        number(element, attribute, "stiffness", 0),
        number(element, attribute, "springref", 0) * unit - reference,
        number(element, attribute, "damping", 0),
        number(element, attribute, "frictionloss", 0),
        Optional.empty());
  }
}
