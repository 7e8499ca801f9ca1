package org.mechservice.robot;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Around;
import org.mechservice.robot.Robot.BodyForce;
import org.mechservice.robot.Robot.Branch;
import org.mechservice.robot.Robot.Coordinate;
import org.mechservice.robot.Robot.Coupling;
import org.mechservice.robot.Robot.CouplingSpring;
import org.mechservice.robot.Robot.Eye;
import org.mechservice.robot.Robot.Force;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.robot.Robot.Freedom;
import org.mechservice.robot.Robot.Input;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.JointForce;
import org.mechservice.robot.Robot.Loop;
import org.mechservice.robot.Robot.Mark;
import org.mechservice.robot.Robot.Muscle;
import org.mechservice.robot.Robot.PathSpring;
import org.mechservice.robot.Robot.PathTension;
import org.mechservice.robot.Robot.PointSpring;
import org.mechservice.robot.Robot.PoseSpring;
import org.mechservice.robot.Robot.State;
import org.mechservice.robot.Robot.Waypoint;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * The loops, couplings, forces and inputs of a robot in MechML, with their points on the bodies.
 */
final class RobotActions {
  /** Where MuJoCo ends its search of the point at which a string touches a ring, rad. */
  static final double TOLERANCE_OF_MUJOCO = 1e-6;

  private static final Vector3 X = new Vector3(1, 0, 0);
  private static final Vector3 Z = new Vector3(0, 0, 1);

  private final Robot robot;
  private final Map<String, List<TagBuilder>> frames = new HashMap<>();

  RobotActions(Robot robot) {
    this.robot = robot;
  }

  /** Returns the points and vectors of a link that {@link #addForces} and the like have needed. */
  List<TagBuilder> frames(String link) {
    return frames.getOrDefault(link, List.of());
  }

  /** Adds the loops and couplings to the constraints. */
  void addConstraints(TagBuilder constraints) {
    robot.loops().forEach(loop -> constraints.add(loop(loop)));
    robot.couplings().forEach(coupling -> constraints.add(coupling(coupling)));
  }

  private TagBuilder loop(Loop loop) {
    TagBuilder tag =
        TagBuilder.of("JointConstraint", loop.element())
            .set("name", loop.name())
            .set("type", loop.rigid() ? "W" : "S");
    boolean turned = loop.rigid();
    return tag.add(
            end(tag, "body1", loop.element(), loop.name(), loop.first(), loop.inFirst(), turned))
        .add(
            end(tag, "body2", loop.element(), loop.name(), loop.second(), loop.inSecond(), turned));
  }

  /** Returns an end of a constraint or force, and notes its point and vectors on the body. */
  private TagBuilder end(
      TagBuilder owner,
      String which,
      Element from,
      String name,
      String link,
      Frame frame,
      boolean turned) {
    String own = name + " " + which;
    List<TagBuilder> all = frames.computeIfAbsent(link, key -> new ArrayList<>());
    addPoint(from, link, own, frame.at());
    TagBuilder end = TagBuilder.of(which, from, owner).set("name", link).set("point", own);
    if (turned) {
      all.add(vector(from, own + " z", frame.turn().apply(Z)));
      all.add(vector(from, own + " x", frame.turn().apply(X)));
      end.set("vector", own + " z").set("vector2", own + " x");
    }
    return end;
  }

  private void addPoint(Element from, String link, String name, Vector3 at) {
    frames
        .computeIfAbsent(link, key -> new ArrayList<>())
        .add(
            TagBuilder.of("point", from)
                .set("name", name)
                .set("x", at.x())
                .set("y", at.y())
                .set("z", at.z()));
  }

  private static TagBuilder vector(Element from, String name, Vector3 v) {
    return TagBuilder.of("vector", from)
        .set("name", name)
        .set("vx", v.x())
        .set("vy", v.y())
        .set("vz", v.z());
  }

  private static TagBuilder coupling(Coupling coupling) {
    TagBuilder tag =
        TagBuilder.of("CoordConstraint", coupling.element()).set("name", coupling.name());
    coupling.expression().ifPresent(expression -> tag.set("expression", expression));
    if (coupling.expression().isEmpty()) {
      tag.set("constant", coupling.constant());
    }
    addTerms(tag, coupling.element(), coupling.terms());
    return tag;
  }

  private static void addTerms(TagBuilder tag, Element from, Map<String, Double> terms) {
    terms.forEach(
        (joint, factor) ->
            tag.add(TagBuilder.of("term", from, tag).set("joint", joint).set("factor", factor)));
  }

  /** Adds the forces, and the inputs to the states. */
  void addForces(TagBuilder forces, TagBuilder states) {
    for (Force force : robot.forces()) {
      if (force instanceof Input input) {
        states.add(
            TagBuilder.of("input", input.element())
                .set("name", input.name())
                .set("unit", input.unit()));
      } else if (force instanceof State state) {
        states.add(
            TagBuilder.of("state", state.element())
                .set("name", state.name())
                .set("derivative", state.derivative())
                .set("unit", state.unit()));
      } else if (force instanceof Mark mark) {
        addPoint(mark.element(), mark.link(), mark.name(), mark.at());
      } else {
        forces.add(force(force));
      }
    }
    robot.joints().forEach(joint -> damp(joint, forces));
    // A spring of MechML has no negative stiffness and no negative damping.
    for (Joint joint : robot.joints()) {
      Coordinate own = joint.coordinate();
      if (joint.type().isSingle() && (own.stiffness() < 0 || own.damping() < 0)) {
        forces.add(
            TagBuilder.of("jointForce", joint.element())
                .set("name", joint.name() + " push")
                .set("joint", joint.name())
                .set("expression", push(joint)));
      }
    }
  }

  /** Adds the damping of a free joint, and what drives a ball: the same along each coordinate. */
  private static void damp(Joint joint, TagBuilder forces) {
    double damping = joint.coordinate().damping();
    boolean drives = joint.type() == Freedom.SPHERICAL && damping < 0;
    int count = joint.type() == Freedom.FLOATING ? 6 : drives ? 3 : 0;
    for (int i = 0; i < count && damping != 0; i++) {
      forces.add(
          TagBuilder.of("jointForce", joint.element())
              .set("name", joint.name() + " damping" + i)
              .set("joint", joint.name())
              .set("component", String.valueOf(i))
              .set(
                  "expression",
                  MechmlText.number(-damping)
                      + "*"
                      + MechmlText.name(joint.name())
                      + ".v["
                      + i
                      + "]"));
    }
  }

  /** Adds what a path passes, and notes its points on the bodies. */
  private void addStops(TagBuilder owner, Element from, String name, List<Waypoint> stops) {
    for (int i = 0; i < stops.size(); i++) {
      String own = name + " " + i;
      if (stops.get(i) instanceof Eye eye) {
        addPoint(from, eye.link(), own, eye.at());
        owner.add(place("via", from, owner, eye.link(), own));
      } else if (stops.get(i) instanceof Around shape) {
        owner.add(around(owner, from, own, shape));
      } else if (stops.get(i) instanceof Branch branch) {
        owner.add(TagBuilder.of("branch", from, owner).set("share", branch.share()));
      }
    }
  }

  private static TagBuilder place(
      String tag, Element from, TagBuilder owner, String link, String point) {
    return TagBuilder.of(tag, from, owner).set("name", link).set("point", point);
  }

  private TagBuilder around(TagBuilder owner, Element from, String own, Around shape) {
    addPoint(from, shape.link(), own, shape.frame().at());
    TagBuilder tag = place("around", from, owner, shape.link(), own).set("radius", shape.radius());
    if (shape.cylinder()) {
      frames
          .computeIfAbsent(shape.link(), key -> new ArrayList<>())
          .add(vector(from, own + " z", shape.frame().turn().apply(Z)));
      tag.set("vector", own + " z");
    }
    if (shape.inside()) {
      tag.set("inside", "true").set("tolerance", TOLERANCE_OF_MUJOCO);
    }
    shape
        .side()
        .filter(side -> !shape.inside())
        .ifPresent(
            side -> {
              addPoint(from, side.link(), own + " side", side.at());
              tag.add(place("side", from, tag, side.link(), own + " side"));
            });
    return tag;
  }

  private static String push(Joint joint) {
    Coordinate own = joint.coordinate();
    String name = MechmlText.name(joint.name());
    String spring =
        own.stiffness() < 0
            ? MechmlText.number(-own.stiffness())
                + "*("
                + name
                + ".q - ("
                + MechmlText.number(own.freePosition())
                + "))"
            : "0";
    return own.damping() < 0
        ? spring + " + " + MechmlText.number(-own.damping()) + "*" + name + ".v"
        : spring;
  }

  private TagBuilder force(Force force) {
    Element from = force.element();
    if (force instanceof JointForce one) {
      return TagBuilder.of("jointForce", from)
          .set("name", one.name())
          .set("joint", one.joint())
          .set("expression", one.expression());
    } else if (force instanceof CouplingSpring one) {
      TagBuilder spring =
          TagBuilder.of("couplingSpringDamper", from)
              .set("name", one.name())
              .set("quantity", one.angle() ? "angle" : "length")
              .set("k", one.stiffness())
              .set("c", one.damping())
              .set("rest", one.rest())
              .set("side", one.side());
      addTerms(spring, from, one.terms());
      return spring;
    } else if (force instanceof PathSpring one) {
      TagBuilder spring =
          TagBuilder.of("elasticRope", from)
              .set("name", one.name())
              .set("k", one.stiffness())
              .set("c", one.damping())
              .set("length0", one.rest())
              .set("side", one.side());
      addStops(spring, from, one.name(), one.stops());
      return spring;
    } else if (force instanceof PathTension one) {
      TagBuilder pull =
          TagBuilder.of("pathForce", from)
              .set("name", one.name())
              .set("expression", one.expression());
      addStops(pull, from, one.name(), one.stops());
      return pull;
    } else if (force instanceof Muscle one) {
      TagBuilder muscle =
          TagBuilder.of("muscle", from).set("name", one.name()).set("excitation", one.excitation());
      one.numbers().forEach(muscle::set);
      addStops(muscle, from, one.name(), one.stops());
      addTerms(muscle, from, one.terms());
      return muscle;
    } else if (force instanceof PoseSpring one) {
      String along = MechmlText.number(one.sliding());
      String about = MechmlText.number(one.turning());
      TagBuilder bushing = TagBuilder.of("bushing", from).set("name", one.name());
      bushing.set("k", along + ";" + along + ";" + along + ";" + about + ";" + about + ";" + about);
      Frame inSecond = new Frame(one.at(), Rotation.IDENTITY);
      addEnd(bushing, "body1", one, one.first(), one.frame().times(inSecond), true);
      addEnd(bushing, "body2", one, one.second(), inSecond, true);
      return bushing;
    } else if (force instanceof PointSpring one) {
      TagBuilder spring =
          TagBuilder.of("springDamper", from)
              .set("name", one.name())
              .set("k", one.stiffness())
              .set("c", one.damping())
              .set("length0", one.rest());
      Frame inFirst = new Frame(one.inFirst(), Rotation.IDENTITY);
      Frame inSecond = new Frame(one.inSecond(), Rotation.IDENTITY);
      addEnd(spring, "body1", one, one.first(), inFirst, false);
      addEnd(spring, "body2", one, one.second(), inSecond, false);
      return spring;
    }
    BodyForce one = (BodyForce) force;
    addPoint(from, one.link(), one.name(), one.at());
    TagBuilder acting =
        TagBuilder.of("forceTorque", from)
            .set("name", one.name())
            .set("body", one.link())
            .set("point", one.name());
    if (one.turning()) {
      acting.set("frame", "body");
    }
    addComponents(acting, "f", one.force());
    addComponents(acting, "t", one.torque());
    return acting;
  }

  /** Adds an end of a force between two bodies. */
  private void addEnd(
      TagBuilder owner, String number, Force force, String link, Frame frame, boolean axes) {
    owner.add(end(owner, number, force.element(), force.name(), link, frame, axes));
  }

  private static void addComponents(TagBuilder acting, String letter, List<String> components) {
    for (int i = 0; i < components.size(); i++) {
      acting.set(letter + "xyz".charAt(i), components.get(i));
    }
  }
}
