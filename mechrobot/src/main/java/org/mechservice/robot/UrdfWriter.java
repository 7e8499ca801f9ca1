package org.mechservice.robot;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointFriction;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Cylindrical;
import org.mechservice.solver.mechanism.joint.Free;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.Universal;
import org.mechservice.solver.mechanism.joint.Weld;
import org.mechservice.solver.spatial.EulerParameters;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * A mechanism as the elements of a robot. The frame of a link has the axes of its body and its
 * origin at the point of the joint that leads to it, where URDF wants it. With A = Rot(a, q) A0 of
 * MechML and A = A0 Rot(b, q) of URDF, the axis in the child is b = A0ᵀ a. Joints C and U become
 * two joints with a link without mass between them.
 */
final class UrdfWriter {
  /** Half the damping over the stiffness of stops that the import makes, s. */
  private static final double STOP_TIME = 0.005;

  /** Free fall as the import and most programs assume it: URDF does not say it, m/s². */
  private static final double GRAVITY = 9.81;

  /** Of the size of a vector that a file gives by its components. */
  private static final double ROUNDING = 1e-12;

  private static final Vector3 DOWN = new Vector3(0, 0, -1);

  private final MechmlModel model;
  private final Element file;
  private final Mechanism mechanism;
  private final UrdfShapes shapes;
  private final ExportLosses losses;
  private final List<List<UrdfCoordinate>> along = new ArrayList<>();

  /**
   * @param file the outermost element of the model file
   */
  UrdfWriter(MechmlModel model, Element file, UrdfShapes shapes, ExportLosses losses) {
    this.model = model;
    this.file = file;
    this.shapes = shapes;
    this.losses = losses;
    mechanism = model.mechanism();
    for (Joint joint : mechanism.joints()) {
      along.add(coordinates(joint));
    }
  }

  /** Returns the coordinates of a joint to each of which URDF gives a joint. */
  private List<UrdfCoordinate> coordinates(Joint joint) {
    if (joint instanceof Revolute || joint instanceof Prismatic) {
      return List.of(new UrdfCoordinate(joint.name(), joint instanceof Revolute));
    } else if (joint instanceof Universal || joint instanceof Cylindrical) {
      return List.of(
          new UrdfCoordinate(unusedJoint(joint.name() + "_1"), joint instanceof Universal),
          new UrdfCoordinate(unusedJoint(joint.name() + "_2"), true));
    }
    return List.of();
  }

  Element robot() {
    mechanism.closures().forEach(this::closure);
    mechanism.forces().forEach(this::force);
    loseTheRest();
    TagBuilder robot = new TagBuilder("robot").set("name", mechanism.name());
    world().forEach(robot::add);
    TagBuilder root = new TagBuilder("link").set("name", mechanism.root().name());
    new UrdfRoot(file, losses).inertial(mechanism.root().name()).ifPresent(root::add);
    shapes.of(mechanism.root().name(), Vector3.ZERO).forEach(root::add);
    robot.add(root);
    for (int b = 0; b < mechanism.bodies().size(); b++) {
      robot.add(link(b));
    }
    for (int j = 0; j < mechanism.joints().size(); j++) {
      joint(j).forEach(robot::add);
    }
    return robot.element();
  }

  /**
   * Returns a link below the root, whose z points against gravity, and the joint between them;
   * nothing if the root is so already.
   */
  private List<TagBuilder> world() {
    Vector3 gravity = mechanism.gravity();
    double size = gravity.norm();
    if (Math.abs(size - GRAVITY) > ROUNDING * GRAVITY) {
      losses.add(
          Origin.NONE,
          "gravity is "
              + ShortestDecimal.format(size)
              + " m/s²; URDF does not say it, and who reads the file assumes some 9.81 m/s²");
    }
    Rotation upright = size > 0 ? UrdfFrames.toZ(gravity.normalized(), DOWN) : Rotation.IDENTITY;
    Frame root =
        new Frame(
            upright.apply(mechanism.root().position()),
            upright.times(mechanism.root().orientation()));
    Optional<TagBuilder> origin = UrdfFrames.origin(root);
    if (origin.isEmpty()) {
      return List.of();
    }
    String name = unused("world");
    TagBuilder joint =
        new TagBuilder("joint").set("name", unusedJoint("root_in_world")).set("type", "fixed");
    return List.of(
        new TagBuilder("link").set("name", name),
        joint.add(origin.get()).add(end("parent", name)).add(end("child", name(Mechanism.ROOT))));
  }

  private String unused(String wanted) {
    boolean taken =
        name(Mechanism.ROOT).equals(wanted)
            || mechanism.bodies().stream().anyMatch(body -> body.name().equals(wanted));
    return taken ? unused(wanted + "_") : wanted;
  }

  private String unusedJoint(String wanted) {
    boolean taken = mechanism.joints().stream().anyMatch(joint -> joint.name().equals(wanted));
    return taken ? unusedJoint(wanted + "_") : wanted;
  }

  private String name(int body) {
    return body == Mechanism.ROOT ? mechanism.root().name() : mechanism.bodies().get(body).name();
  }

  private static TagBuilder end(String tag, String link) {
    return new TagBuilder(tag).set("link", link);
  }

  /** Returns the origin of a link from that of its body, in body axes, m. */
  private Vector3 shift(int body) {
    return body == Mechanism.ROOT
        ? Vector3.ZERO
        : mechanism.joints().get(mechanism.jointOf(body)).attachment().childPoint();
  }

  private TagBuilder link(int index) {
    Body body = mechanism.bodies().get(index);
    TagBuilder link = new TagBuilder("link").set("name", body.name());
    Vector3 frame = shift(index).negated();
    if (!body.isMassless()) {
      TagBuilder inertial = new TagBuilder("inertial");
      UrdfFrames.origin(new Frame(body.centerOfMass().plus(frame), Rotation.IDENTITY))
          .ifPresent(inertial::add);
      InertiaTensor i = body.inertia();
      inertial
          .add(new TagBuilder("mass").set("value", body.mass()))
          .add(
              new TagBuilder("inertia")
                  .set("ixx", i.xx())
                  .set("ixy", i.xy())
                  .set("ixz", i.xz())
                  .set("iyy", i.yy())
                  .set("iyz", i.yz())
                  .set("izz", i.zz()));
      link.add(inertial);
    }
    shapes.of(body.name(), frame).forEach(link::add);
    return link;
  }

  private List<TagBuilder> joint(int index) {
    Joint joint = mechanism.joints().get(index);
    if (mechanism.isDriven(index)) {
      losses.add(
          joint.origin(),
          "the motion of joint \"" + joint.name() + "\" is prescribed; in URDF it is free");
    }
    Attachment at = joint.attachment();
    String parent = name(at.parent());
    String child = name(at.child());
    if (joint instanceof Free free) {
      return List.of(joint(joint.name(), "floating", start(free), parent, child));
    }
    loseStart(index, joint);
    Rotation toChild = at.zeroRotation().transposed();
    List<UrdfCoordinate> has = along.get(index);
    if (joint instanceof Weld) {
      return List.of(joint(joint.name(), "fixed", zero(at), parent, child));
    } else if (joint instanceof Revolute || joint instanceof Prismatic) {
      Vector3 axis = toChild.apply(joint.axes().get(0));
      return List.of(moving(has.get(0), zero(at), parent, child, axis));
    } else if (joint instanceof Cylindrical) {
      Vector3 axis = toChild.apply(joint.axes().get(0));
      return chain(at, has.get(0), axis, has.get(1), axis);
    } else if (joint instanceof Universal universal) {
      // A = Rot(a1, q1) A0 Rot(a2, q2) = A0 Rot(A0ᵀ a1, q1) Rot(a2, q2); the tree's other direction
      // is Aᵀ = A0ᵀ Rot(-A0 a2, q2) Rot(-a1, q1), whose zero rotation is A0ᵀ.
      return universal.fileBody2IsParent()
          ? chain(
              at,
              has.get(1),
              toChild.apply(universal.axis2().negated()),
              has.get(0),
              universal.axis1().negated())
          : chain(at, has.get(0), toChild.apply(universal.axis1()), has.get(1), universal.axis2());
    }
    losses.refuse(
        joint.origin(),
        "joint \""
            + joint.name()
            + "\" is of type "
            + joint.type()
            + ", which URDF does not have; it has R, P, F and W, and C and U as two of them");
    return List.of();
  }

  /** Returns two joints one after the other, and the link without mass between them. */
  private List<TagBuilder> chain(
      Attachment at, UrdfCoordinate inner, Vector3 first, UrdfCoordinate outer, Vector3 second) {
    String between = unused(inner.name() + "_" + outer.name());
    Frame same = new Frame(Vector3.ZERO, Rotation.IDENTITY);
    return List.of(
        new TagBuilder("link").set("name", between),
        moving(inner, zero(at), name(at.parent()), between, first),
        moving(outer, same, between, name(at.child()), second));
  }

  private static TagBuilder joint(
      String name, String type, Frame frame, String parent, String child) {
    TagBuilder tag = new TagBuilder("joint").set("name", name).set("type", type);
    UrdfFrames.origin(frame).ifPresent(tag::add);
    return tag.add(end("parent", parent)).add(end("child", child));
  }

  /**
   * Returns a joint with one coordinate.
   *
   * @param axis in the axes of the child
   */
  private static TagBuilder moving(
      UrdfCoordinate coordinate, Frame frame, String parent, String child, Vector3 axis) {
    TagBuilder tag = joint(coordinate.name(), coordinate.type(), frame, parent, child);
    tag.add(new TagBuilder("axis").set("xyz", UrdfFrames.text(axis)));
    coordinate.addTo(tag);
    return tag;
  }

  private Frame zero(Attachment at) {
    return new Frame(at.parentPoint().minus(shift(at.parent())), at.zeroRotation());
  }

  /** Returns the pose in which a free body starts, which URDF has as the frame of its joint. */
  private Frame start(Free free) {
    List<Double> q = free.start().positions();
    double[] e = {q.get(0), q.get(1), q.get(2), q.get(3)};
    double[] r = new double[9];
    EulerParameters.rotation(e, 0, r, 0);
    Rotation turn = new Rotation(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]);
    Frame moved = new Frame(new Vector3(q.get(4), q.get(5), q.get(6)), turn);
    Frame child = free.fileBody2IsParent() ? moved.inverse() : moved;
    if (free.start().velocities().stream().anyMatch(v -> v != 0)) {
      losses.add(
          free.origin(),
          "the start velocity of joint \"" + free.name() + "\" is left out: URDF has none");
    }
    Attachment at = free.attachment();
    return new Frame(at.parentPoint().minus(shift(at.parent())).plus(child.at()), child.turn());
  }

  private void loseStart(int index, Joint joint) {
    if (mechanism.isDriven(index)) {
      return;
    }
    double[] y = new double[mechanism.stateCount()];
    int positions = joint.type().positionCount();
    joint.initialPositions(y, 0);
    joint.initialVelocities(y, positions);
    List<UrdfCoordinate> has = along.get(index);
    boolean lost = false;
    for (int k = 0; k < has.size(); k++) {
      lost |= !has.get(k).startsAt(y[k]) || y[positions + k] != 0;
    }
    if (lost) {
      losses.add(
          joint.origin(),
          "the start values of joint \"" + joint.name() + "\" are left out: URDF has none");
    }
  }

  /** Takes a coupling of two coordinates; refuses everything else that closes a loop. */
  private void closure(LoopClosure closure) {
    Optional<LinearRelation> relation =
        closure instanceof CoordinateClosure coupling
            ? LinearRelation.of(coupling.relation(), mechanism, this::isPosition)
            : Optional.empty();
    List<JointCoordinate> moved =
        relation
            .map(
                r ->
                    r.factors().keySet().stream()
                        .map(one -> coordinate(one).orElseThrow())
                        .sorted(
                            Comparator.comparingInt(JointCoordinate::joint)
                                .thenComparingInt(JointCoordinate::component))
                        .toList())
            .orElse(List.of());
    if (moved.size() == 2) {
      LinearRelation all = relation.orElseThrow();
      // The coordinate with the factor 1 follows, as the import writes it; else the second.
      boolean first = all.factor(new Expression.CoordinatePosition(moved.get(0))) == 1.0;
      JointCoordinate follower = moved.get(first ? 0 : 1);
      JointCoordinate other = moved.get(first ? 1 : 0);
      double own = all.factor(new Expression.CoordinatePosition(follower));
      double multiplier = -all.factor(new Expression.CoordinatePosition(other)) / own;
      if (own != 0 && at(follower).follow(at(other).name(), multiplier, -all.constant() / own)) {
        return;
      }
    }
    losses.refuse(
        closure.origin(),
        "\""
            + closure.name()
            + "\" closes a loop or couples coordinates as URDF cannot, which has trees and"
            + " coordinates that follow one other");
  }

  private boolean isPosition(Expression expression) {
    return coordinate(expression).filter(this::has).isPresent();
  }

  private static Optional<JointCoordinate> coordinate(Expression expression) {
    return expression instanceof Expression.CoordinatePosition position
            && position.coordinate() instanceof JointCoordinate of
        ? Optional.of(of)
        : Optional.empty();
  }

  private boolean has(JointCoordinate of) {
    return of.component() < along.get(of.joint()).size();
  }

  private UrdfCoordinate at(JointCoordinate of) {
    return along.get(of.joint()).get(of.component());
  }

  private Optional<Double> number(Expression expression) {
    return LinearRelation.number(expression, mechanism);
  }

  /** Takes what URDF has along a coordinate: damping, friction and stops; the rest is lost. */
  private void force(ForceElement force) {
    Optional<UrdfCoordinate> place = force.jointCoordinate().flatMap(this::along);
    boolean taken =
        place.isPresent()
            && ((force instanceof JointSpringDamper spring && spring(spring, place.get()))
                || (force instanceof JointFriction friction && friction(friction, place.get())));
    if (!taken) {
      losses.add(
          force.origin(),
          "force \"" + force.name() + "\" (" + force.kind() + ") is left out: URDF has none such");
    }
  }

  private Optional<UrdfCoordinate> along(Coordinate coordinate) {
    return coordinate instanceof JointCoordinate of && has(of)
        ? Optional.of(at(of))
        : Optional.empty();
  }

  private boolean spring(JointSpringDamper spring, UrdfCoordinate at) {
    Optional<Double> damping = number(spring.damping());
    Optional<Double> stiffness = number(spring.stiffness());
    Optional<Double> position = number(spring.position0());
    Optional<Double> force = number(spring.force0());
    if (damping.isEmpty() || stiffness.isEmpty() || position.isEmpty() || force.isEmpty()) {
      return false;
    }
    if (spring.side() != Side.BOTH) {
      boolean taken = at.stop(spring.side(), position.get());
      if (taken) {
        loseStop(spring);
      }
      return taken;
    }
    at.damp(damping.get());
    if (stiffness.get() != 0 || force.get() != 0) {
      losses.add(
          spring.origin(),
          "the stiffness of \"" + spring.name() + "\" is left out: a joint of URDF has no spring");
    }
    return true;
  }

  /** Reports stops that the import would not give the joint again. */
  private void loseStop(JointSpringDamper stop) {
    double stiffness = number(stop.stiffness()).orElse(Double.NaN);
    double time = number(stop.damping()).orElse(Double.NaN) / (2 * stiffness);
    boolean same =
        Math.abs(time - STOP_TIME) < 1e-9 * STOP_TIME
            && number(stop.smoothing()).orElse(Double.NaN) == 0;
    if (!same) {
      losses.add(
          stop.origin(),
          "stiffness, damping and smoothing of \""
              + stop.name()
              + "\" are left out: a limit of URDF is a number");
    }
  }

  private boolean friction(JointFriction friction, UrdfCoordinate at) {
    Optional<Double> coulomb = number(friction.coulomb());
    Optional<Double> viscous = number(friction.viscous());
    if (coulomb.isEmpty() || viscous.isEmpty() || !at.rub(coulomb.get())) {
      return false;
    }
    at.damp(viscous.get());
    if (number(friction.speed()).orElse(Double.NaN) != (at.turns() ? 0.01 : 0.001)) {
      losses.add(
          friction.origin(),
          "the transition speed of \""
              + friction.name()
              + "\" is left out: friction of URDF is a number");
    }
    return true;
  }

  private void loseTheRest() {
    List<String> lost = new ArrayList<>();
    for (FurtherState state : mechanism.furtherStates()) {
      lost.add("state \"" + state.name() + "\"");
    }
    model.settings().events().forEach(event -> lost.add("event \"" + event.name() + "\""));
    model.outputs().forEach(output -> lost.add("output \"" + output.name() + "\""));
    lost.forEach(what -> losses.add(Origin.NONE, what + " is left out: URDF has none such"));
  }
}
