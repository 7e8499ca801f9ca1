package org.mechservice.robot;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Freedom;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Place;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * The joints of a robot in MechML. Two vectors define the child's frame at zero: the axis and a
 * vector normal to it, each in the axes of both bodies.
 */
final class RobotJoints {
  /** Assumed values of quantities that URDF does not define. */
  private enum Assumption {
    ANGLE_STOP_STIFFNESS("angleStopStiffness", "1e4", "N*m/rad"),
    ANGLE_STOP_DAMPING("angleStopDamping", "10", "N*m*s/rad"),
    LENGTH_STOP_STIFFNESS("lengthStopStiffness", "1e6", "N/m"),
    LENGTH_STOP_DAMPING("lengthStopDamping", "1e3", "N*s/m"),
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

  /** The joints of each link, of which it is the parent or the child, in the robot's order. */
  private final Map<String, List<Joint>> ofLink = new HashMap<>();

  RobotJoints(Robot robot, RobotTree tree) {
    this.robot = robot;
    this.tree = tree;
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
      case ANGLE_STOP_STIFFNESS, ANGLE_STOP_DAMPING ->
          joint.coordinate().limits().isPresent() && !slides;
      case LENGTH_STOP_STIFFNESS, LENGTH_STOP_DAMPING ->
          joint.coordinate().limits().isPresent() && slides;
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
    if (joint.coordinate().stiffness() > 0) {
      tag.set("stiffness", joint.coordinate().stiffness());
      tag.set("freePosition", joint.coordinate().freePosition());
    }
    if (joint.coordinate().damping() > 0) {
      tag.set("damping", joint.coordinate().damping());
    }
    boolean slides = joint.type() == Freedom.PRISMATIC;
    if (joint.coordinate().friction() > 0) {
      tag.set("friction", joint.coordinate().friction());
      tag.set("frictionSpeed", slides ? "lengthFrictionSpeed" : "angleFrictionSpeed");
    }
    joint
        .coordinate()
        .limits()
        .ifPresent(
            range -> {
              tag.set("lower", range.lower()).set("upper", range.upper());
              tag.set("stopStiffness", slides ? "lengthStopStiffness" : "angleStopStiffness");
              tag.set("stopDamping", slides ? "lengthStopDamping" : "angleStopDamping");
            });
    return tag.add(end(tag, joint, "body1", joint.parent(), joint.name()))
        .add(end(tag, joint, "body2", joint.child(), childPoint(joint)))
        .element();
  }

  private static TagBuilder end(
      TagBuilder joint, Joint from, String name, String body, String point) {
    TagBuilder end =
        TagBuilder.of(name, from.element(), joint).set("name", body).set("point", point);
    return hasVectors(from)
        ? end.set("vector", from.name() + "_axis").set("vector2", from.name() + "_side")
        : end;
  }

  /** Returns the start position of a joint; empty if it is zero. */
  Optional<TagBuilder> start(Joint joint) {
    if (joint.type().turnsFreely()) {
      if (tree.closes(joint)) {
        return Optional.empty();
      }
      String turn =
          joint.place().frame().eulerParameters().stream()
              .map(value -> ShortestDecimal.format(value + 0.0))
              .collect(Collectors.joining(";"));
      return Optional.of(
          value(joint).set("posVals", joint.type() == Freedom.FLOATING ? turn + ";0;0;0" : turn));
    }
    double position = tree.start().getOrDefault(joint.name(), 0.0);
    return position == 0 ? Optional.empty() : Optional.of(value(joint).set("posVals", position));
  }

  private static TagBuilder value(Joint joint) {
    return TagBuilder.of("jointVal", joint.element()).set("name", joint.name());
  }
}
