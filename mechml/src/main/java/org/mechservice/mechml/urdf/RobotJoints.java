package org.mechservice.mechml.urdf;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.urdf.UrdfRobot.Freedom;
import org.mechservice.mechml.urdf.UrdfRobot.Joint;
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

  private final UrdfRobot robot;
  private final UrdfTree tree;
  private final String origin;

  RobotJoints(UrdfRobot robot, UrdfTree tree) {
    this.robot = robot;
    this.tree = tree;
    String free = "origin";
    while (isJoint(free)) {
      free += "_";
    }
    origin = free;
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
      case ANGLE_STOP_STIFFNESS, ANGLE_STOP_DAMPING -> joint.limits().isPresent() && !slides;
      case LENGTH_STOP_STIFFNESS, LENGTH_STOP_DAMPING -> joint.limits().isPresent() && slides;
      case ANGLE_FRICTION_SPEED -> joint.friction() > 0 && !slides;
      case LENGTH_FRICTION_SPEED -> joint.friction() > 0 && slides;
    };
  }

  /** Returns the points and vectors of a link. */
  List<TagBuilder> frames(String link) {
    List<TagBuilder> frames = new ArrayList<>();
    for (Joint joint : robot.joints()) {
      Rotation turn = joint.frame().turn();
      if (joint.parent().equals(link)) {
        frames.add(
            point(TagBuilder.of("point", joint.element()), joint.name(), joint.frame().at()));
        if (hasVectors(joint)) {
          frames.add(vector(joint, "_axis", turn.apply(joint.axis())));
          frames.add(vector(joint, "_side", turn.apply(across(joint.axis()))));
        }
      } else if (joint.child().equals(link)) {
        frames.add(point(TagBuilder.of("point", joint.element()), origin, Vector3.ZERO));
        if (hasVectors(joint)) {
          frames.add(vector(joint, "_axis", joint.axis()));
          frames.add(vector(joint, "_side", across(joint.axis())));
        }
      }
    }
    return frames;
  }

  private static boolean hasVectors(Joint joint) {
    return joint.type() != Freedom.FLOATING;
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

  /** Returns a unit vector normal to another, a coordinate axis if possible. */
  private static Vector3 across(Vector3 axis) {
    double x = Math.abs(axis.x());
    double y = Math.abs(axis.y());
    double z = Math.abs(axis.z());
    Vector3 least =
        x <= y && x <= z
            ? new Vector3(1, 0, 0)
            : y <= z ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
    return least.minus(axis.times(axis.dot(least))).normalized();
  }

  /** Returns a joint. */
  Element joint(Joint joint) {
    TagBuilder tag =
        TagBuilder.of("joint", joint.element())
            .set("name", joint.name())
            .set("type", letter(joint.type()));
    if (joint.damping() > 0) {
      tag.set("damping", joint.damping());
    }
    boolean slides = joint.type() == Freedom.PRISMATIC;
    if (joint.friction() > 0) {
      tag.set("friction", joint.friction());
      tag.set("frictionSpeed", slides ? "lengthFrictionSpeed" : "angleFrictionSpeed");
    }
    joint
        .limits()
        .ifPresent(
            range -> {
              tag.set("lower", range.lower()).set("upper", range.upper());
              tag.set("stopStiffness", slides ? "lengthStopStiffness" : "angleStopStiffness");
              tag.set("stopDamping", slides ? "lengthStopDamping" : "angleStopDamping");
            });
    return tag.add(end(tag, joint, "body1", joint.parent(), joint.name()))
        .add(end(tag, joint, "body2", joint.child(), origin))
        .element();
  }

  private static String letter(Freedom type) {
    return switch (type) {
      case REVOLUTE, CONTINUOUS -> "R";
      case PRISMATIC -> "P";
      case FIXED -> "W";
      case FLOATING -> "F";
      case PLANAR -> "PL";
    };
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
    if (joint.type() == Freedom.FLOATING) {
      String turn =
          joint.frame().eulerParameters().stream()
              .map(value -> ShortestDecimal.format(value + 0.0))
              .collect(Collectors.joining(";"));
      return Optional.of(value(joint).set("posVals", turn + ";0;0;0"));
    }
    double position = tree.start().getOrDefault(joint.name(), 0.0);
    return position == 0 ? Optional.empty() : Optional.of(value(joint).set("posVals", position));
  }

  private static TagBuilder value(Joint joint) {
    return TagBuilder.of("jointVal", joint.element()).set("name", joint.name());
  }
}
