package org.mechservice.robot;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Coordinate;
import org.mechservice.robot.Robot.Freedom;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Place;
import org.mechservice.robot.Robot.Range;
import org.mechservice.robot.Robot.Start;
import org.mechservice.robot.Robot.Stop;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * The joints of a robot in MechML. Two vectors define the child's frame at zero: the axis and a
 * vector normal to it, each in the axes of both bodies.
 */
final class RobotJoints {
  /**
   * Assumed values of quantities that a format does not define. Stops take their stiffness from the
   * inertia that they hold and this time: 5 ms are short beside the swing of a fingertip, and long
   * beside the steps of an integrator.
   */
  private enum Assumption {
    STOP_TIME("stopTime", "0.005", "s"),
    STOP_DAMPING_RATIO("stopDampingRatio", "1", "1"),
    ANGLE_FRICTION_SPEED("angleFrictionSpeed", "0.01", "rad/s"),
    LENGTH_FRICTION_SPEED("lengthFrictionSpeed", "0.001", "m/s");

    private final String parameter;
    private final String value;
    private final String unit;

    Assumption(String parameter, String value, String unit) {
      this.parameter = parameter;
      this.value = value;
      this.unit = unit;
    }
  }

  private final Robot robot;
  private final RobotTree tree;
  private final String origin;
  private final RobotInertia inertia;

  /** The joints of each link, of which it is the parent or the child, in the robot's order. */
  private final Map<String, List<Joint>> ofLink = new HashMap<>();

  RobotJoints(Robot robot, RobotTree tree) {
    this.robot = robot;
    this.tree = tree;
    inertia = new RobotInertia(robot.links(), robot.joints());
    String free = "origin";
    while (isJoint(free)) {
      free += "_";
    }
    origin = free;
    for (Joint joint : robot.joints()) {
      for (String link : Set.copyOf(List.of(joint.parent(), joint.child()))) {
        ofLink.computeIfAbsent(link, key -> new ArrayList<>()).add(joint);
      }
    }
  }

  private boolean isJoint(String name) {
    return robot.joints().stream().anyMatch(joint -> joint.name().equals(name));
  }

  /** Returns the assumed values as parameters. */
  TagBuilder parameters() {
    TagBuilder parameters = new TagBuilder("Parameters");
    for (Assumption assumption : Assumption.values()) {
      if (robot.joints().stream().anyMatch(joint -> needs(joint, assumption))) {
        parameters.add(
            new TagBuilder("parameter")
                .set("name", assumption.parameter)
                .set("value", assumption.value)
                .set("unit", assumption.unit));
      }
    }
    return parameters;
  }

  private static boolean needs(Joint joint, Assumption assumption) {
    boolean slides = joint.type() == Freedom.PRISMATIC;
    return switch (assumption) {
      case STOP_TIME, STOP_DAMPING_RATIO ->
          joint.coordinate().limits().isPresent() && joint.coordinate().stop().isAssumed();
      case ANGLE_FRICTION_SPEED -> joint.coordinate().friction() > 0 && !slides;
      case LENGTH_FRICTION_SPEED -> joint.coordinate().friction() > 0 && slides;
    };
  }

  /** Returns the points and vectors of a link. */
  List<TagBuilder> frames(String link) {
    List<TagBuilder> frames = new ArrayList<>();
    for (Joint joint : ofLink.getOrDefault(link, List.of())) {
      Place place = joint.place();
      Rotation turn = place.frame().turn();
      if (joint.parent().equals(link)) {
        frames.add(
            point(TagBuilder.of("point", joint.element()), joint.name(), place.pointOnParent()));
        if (hasVectors(joint)) {
          frames.add(vector(joint, "_axis", turn.apply(place.axis())));
          frames.add(vector(joint, "_side", turn.apply(place.side())));
        }
      } else {
        frames.add(
            point(TagBuilder.of("point", joint.element()), childPoint(joint), place.point()));
        if (hasVectors(joint)) {
          frames.add(vector(joint, "_axis", place.axis()));
          frames.add(vector(joint, "_side", place.side()));
        }
      }
    }
    return frames;
  }

  /** Returns the name of the joint's point on its child: the child's origin needs one only once. */
  private String childPoint(Joint joint) {
    return joint.place().point().equals(Vector3.ZERO) && !tree.closes(joint)
        ? origin
        : joint.name();
  }

  private static boolean hasVectors(Joint joint) {
    return !joint.type().turnsFreely();
  }

  private static TagBuilder point(TagBuilder point, String name, Vector3 at) {
    return point.set("name", name).set("x", at.x()).set("y", at.y()).set("z", at.z());
  }

  private static TagBuilder vector(Joint joint, String end, Vector3 v) {
    return TagBuilder.of("vector", joint.element())
        .set("name", joint.name() + end)
        .set("vx", v.x())
        .set("vy", v.y())
        .set("vz", v.z());
  }

  /** Returns a joint. */
  Element joint(Joint joint) {
    TagBuilder tag =
        TagBuilder.of("joint", joint.element())
            .set("name", joint.name())
            .set("type", joint.type().letter());
    if (joint.place().lead() != 0) {
      tag.set("lead", joint.place().lead());
    }
    Coordinate coordinate = joint.coordinate();
    if (coordinate.armature() > 0) {
      String armature = MechmlText.number(coordinate.armature());
      tag.set("armature", joint.type() == Freedom.FLOATING ? armature + ";" + armature : armature);
    }
    if (coordinate.stiffness() > 0) {
      tag.set("stiffness", coordinate.stiffness());
      tag.set("freePosition", coordinate.freePosition());
    }
    boolean damped = joint.type().isSingle() || joint.type() == Freedom.SPHERICAL;
    if (coordinate.damping() > 0 && damped) {
      tag.set("damping", coordinate.damping());
    }
    boolean slides = joint.type() == Freedom.PRISMATIC;
    if (coordinate.friction() > 0) {
      tag.set("friction", coordinate.friction());
      tag.set("frictionSpeed", slides ? "lengthFrictionSpeed" : "angleFrictionSpeed");
    }
    coordinate.limits().ifPresent(range -> addStops(tag, joint, range));
    return tag.add(end(tag, joint, "body1", joint.parent(), joint.name()))
        .add(end(tag, joint, "body2", joint.child(), childPoint(joint)))
        .element();
  }

  private void addStops(TagBuilder tag, Joint joint, Range range) {
    if (Double.isFinite(range.lower())) {
      tag.set("lower", range.lower());
    }
    if (Double.isFinite(range.upper())) {
      tag.set("upper", range.upper());
    }
    Stop stop = joint.coordinate().stop();
    if (stop.stiffness() > 0) {
      tag.set("stopStiffness", stop.stiffness()).set("stopDamping", stop.damping());
      return;
    }
    double held = inertia.free(joint.name());
    double m = held > 0 ? rounded(held) : 1;
    if (stop.isAssumed()) {
      String number = MechmlText.number(m);
      tag.set("stopStiffness", number + "/(stopTime*stopDampingRatio)^2");
      tag.set("stopDamping", "2*" + number + "/stopTime");
    } else {
      tag.set("stopStiffness", rounded(m / Math.pow(stop.time() * stop.ratio(), 2)));
      tag.set("stopDamping", rounded(2 * m / stop.time()));
    }
  }

  /** Returns a number with three digits: more of them say nothing about a stop. */
  private static double rounded(double value) {
    return new BigDecimal(value).round(new MathContext(3)).doubleValue();
  }

  private static TagBuilder end(
      TagBuilder joint, Joint from, String name, String body, String point) {
    TagBuilder end =
        TagBuilder.of(name, from.element(), joint).set("name", body).set("point", point);
    return hasVectors(from)
        ? end.set("vector", from.name() + "_axis").set("vector2", from.name() + "_side")
        : end;
  }

  /** Returns the start of a joint; empty if it is zero. */
  Optional<TagBuilder> start(Joint joint) {
    // MechML may cut another joint of a loop, so that one that turns freely has its start always.
    if (tree.closes(joint) && !joint.type().turnsFreely()) {
      return Optional.empty();
    }
    Start given = robot.starts().get(joint.name());
    if (given != null) {
      TagBuilder start = value(joint).set("posVals", list(given.positions()));
      return Optional.of(
          given.velocities().stream().allMatch(v -> v == 0)
              ? start
              : start.set("velVals", list(given.velocities())));
    }
    if (joint.type().turnsFreely()) {
      String turn = list(joint.place().frame().eulerParameters());
      return Optional.of(
          value(joint).set("posVals", joint.type() == Freedom.FLOATING ? turn + ";0;0;0" : turn));
    }
    double position = tree.start().getOrDefault(joint.name(), 0.0);
    return position == 0 ? Optional.empty() : Optional.of(value(joint).set("posVals", position));
  }

  private static String list(List<Double> values) {
    return values.stream().map(MechmlText::number).collect(Collectors.joining(";"));
  }

  private static TagBuilder value(Joint joint) {
    return TagBuilder.of("jointVal", joint.element()).set("name", joint.name());
  }
}
