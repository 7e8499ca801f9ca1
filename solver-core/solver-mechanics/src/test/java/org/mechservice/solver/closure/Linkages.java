package org.mechservice.solver.closure;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.RandomJoints;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Cylindrical;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.JointStart;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.Screw;
import org.mechservice.solver.mechanism.joint.Spherical;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.oracle.GlobalFormulation;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Small mechanisms with loops. */
final class Linkages {
  static final Vector3 X = new Vector3(1, 0, 0);
  static final Vector3 Y = new Vector3(0, 1, 0);
  static final Vector3 Z = new Vector3(0, 0, 1);
  static final Root GROUND = new Root("ground", Vector3.ZERO, Rotation.IDENTITY);

  private Linkages() {}

  /** Joins bodies, joints that may all move at the start, and closures, in gravity along −z. */
  static Mechanism mechanism(
      String name, List<Body> bodies, List<Joint> joints, List<LoopClosure> closures) {
    return new Mechanism(
        name,
        GROUND,
        Z.times(-9.81),
        bodies,
        joints,
        List.of(),
        Collections.nCopies(joints.size(), StartRole.PREFERRED),
        closures,
        List.of(),
        List.of());
  }

  /** A point mass on two crossed slides, held at a distance of 1 m from the origin. */
  static Mechanism slidingPendulum(double rodMass) {
    List<Body> bodies =
        List.of(
            new Body("slide", 0, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE),
            new Body("mass", 1, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE));
    List<Joint> joints = new ArrayList<>();
    joints.add(new Prismatic("x", between(BodyPoint.ROOT, 0), X, 1, 0, Origin.NONE));
    joints.add(new Prismatic("z", between(0, 1), Z, 0, 0, Origin.NONE));
    LoopClosure rod =
        new DistanceClosure(
            "rod",
            new BodyPoint(BodyPoint.ROOT, Vector3.ZERO),
            new BodyPoint(1, Vector3.ZERO),
            1,
            rodMass,
            Origin.NONE);
    return mechanism("sliding pendulum", bodies, joints, List.of(rod));
  }

  private static Attachment between(int parent, int child) {
    return new Attachment(parent, Vector3.ZERO, child, Vector3.ZERO, Rotation.IDENTITY);
  }

  /**
   * A joint between two bodies whose frames are those of the world at the start, as are all angles
   * and ways zero.
   *
   * @param body1 index, or −1 for ground
   * @param point where it is in the world
   * @param axis of R, P, C; any for S
   */
  record Hinge(String name, JointType type, int body1, int body2, Vector3 point, Vector3 axis) {
    Joint joint() {
      Attachment at = new Attachment(body1, point, body2, point, Rotation.IDENTITY);
      JointStart start = JointStart.atZero(type);
      return switch (type) {
        case R -> new Revolute(name, at, axis, 0, 0, Origin.NONE);
        case P -> new Prismatic(name, at, axis, 0, 0, Origin.NONE);
        case C -> new Cylindrical(name, at, axis, start, Origin.NONE);
        case S -> new Spherical(name, at, start, false, Origin.NONE);
        default -> throw new IllegalArgumentException(name + " of type " + type);
      };
    }
  }

  /**
   * Joins bodies by hinges, of which one is cut; the others lead outwards from ground. All starts
   * at rest.
   *
   * @param cut index of the hinge that closes the loop
   */
  static Mechanism ring(String name, List<Body> bodies, List<Hinge> hinges, int cut) {
    Joint[] inner = new Joint[bodies.size()];
    for (int added = 0; added < bodies.size(); ) {
      for (int h = 0; h < hinges.size(); h++) {
        Joint joint = hinges.get(h).joint();
        int parent = joint.attachment().parent();
        int child = joint.attachment().child();
        if (h != cut && isReached(parent, inner) != isReached(child, inner)) {
          Joint outward = isReached(parent, inner) ? joint : joint.reversed();
          inner[outward.attachment().child()] = outward;
          added++;
        }
      }
    }
    JointClosure closure = new JointClosure(hinges.get(cut).joint());
    return mechanism(name, bodies, List.of(inner), List.of(closure));
  }

  private static boolean isReached(int body, Joint[] inner) {
    return body == BodyPoint.ROOT || inner[body] != null;
  }

  /**
   * A planar four-bar in the x-z plane: A and D on ground, bars AB, BC, CD, hinges about −y.
   *
   * <pre>
   *      B ------ C
   *     /          \
   *    A            D
   * </pre>
   *
   * @param types of the joints at A, B, C, D; with R everywhere three equations are redundant
   * @param cut which of them closes the loop
   */
  static Mechanism fourBar(List<JointType> types, int cut) {
    Vector3 a = new Vector3(0, 0, 0);
    Vector3 b = new Vector3(0.3, 0, 0.4);
    Vector3 c = new Vector3(1.3, 0, 0.7);
    Vector3 d = new Vector3(1.5, 0, 0);
    List<Body> bars = List.of(bar("AB", a, b, 1), bar("BC", b, c, 2), bar("CD", c, d, 1.5));
    Vector3 axis = Y.negated();
    List<Hinge> hinges =
        List.of(
            new Hinge("A", types.get(0), -1, 0, a, axis),
            new Hinge("B", types.get(1), 0, 1, b, axis),
            new Hinge("C", types.get(2), 1, 2, c, axis),
            new Hinge("D", types.get(3), 2, -1, d, axis));
    return ring("four-bar", bars, hinges, cut);
  }

  /**
   * Ground, a hinge, a bar, a joint of any type, and a body that a rod holds to ground; seeded and
   * moving.
   */
  static Mechanism heldByRod(JointType type, long seed) {
    Random random = new Random(seed);
    List<Body> bodies =
        List.of(bar("inner", Vector3.ZERO, X, 1), bar("outer", Z, new Vector3(0.3, 0.2, 0.1), 2));
    List<Joint> joints =
        List.of(
            RandomJoints.joint(random, JointType.R, -1, 0), RandomJoints.joint(random, type, 0, 1));
    BodyPoint end = new BodyPoint(1, new Vector3(0.1, 0.4, 0.3));
    Vector3 onGround = new Vector3(0.5, 1.5, -0.4);
    double length = place(mechanism("open", bodies, joints, List.of()), end).minus(onGround).norm();
    LoopClosure rod =
        new DistanceClosure(
            "rod", new BodyPoint(BodyPoint.ROOT, onGround), end, length, 0, Origin.NONE);
    return mechanism("held", bodies, joints, List.of(rod));
  }

  /** Where a point of a body is at the start, by the oracle. */
  private static Vector3 place(Mechanism open, BodyPoint point) {
    double[] y = new double[open.positionCount() + open.velocityCount()];
    open.initialState(y);
    double[] still = new double[open.velocityCount()];
    return new GlobalFormulation(open, List.of())
        .poses(0, y, still, still)[point.body()]
        .at(point.position())
        .value();
  }

  /**
   * Windows in a row: uprights 1 m high on ground, couplers 1 m long between their tops, all
   * turning together. Flat, every window may go on as a parallelogram or crossed, so one freedom
   * becomes as many as there are windows, and one.
   *
   * <pre>
   *   +---+---+---+
   *   |   |   |   |
   * --+---+---+---+--
   * </pre>
   *
   * @param speed of the uprights at the start, rad/s
   */
  static Mechanism windows(int count, double speed) {
    return windows(count, speed, 1);
  }

  /** As {@link #windows(int, double)}, with couplers of any mass. */
  static Mechanism windows(int count, double speed, double couplerMass) {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    List<LoopClosure> closures = new ArrayList<>();
    for (int i = 0; i <= count; i++) {
      Vector3 foot = X.times(i);
      bodies.add(bar("upright" + i, foot, foot.plus(Z), 1));
      joints.add(turning("foot" + i, BodyPoint.ROOT, i, foot, speed));
    }
    for (int i = 1; i <= count; i++) {
      Vector3 left = X.times(i - 1).plus(Z);
      Vector3 right = X.times(i).plus(Z);
      int coupler = count + i;
      bodies.add(bar("coupler" + i, left, right, couplerMass));
      joints.add(turning("top" + i, i - 1, coupler, left, -speed));
      closures.add(
          new PointOnLineClosure(
              "window" + i,
              new BodyPoint(coupler, right),
              new BodyPoint(i, right),
              Y,
              Origin.NONE));
    }
    return mechanism("windows", bodies, joints, closures);
  }

  /**
   * Windows of a left and a right upright and a coupler each, which share nothing but the ground.
   */
  static Mechanism separateWindows(int count, double speed) {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    List<LoopClosure> closures = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Vector3 foot = X.times(2 * i);
      Vector3 left = foot.plus(Z);
      Vector3 right = left.plus(X);
      int first = bodies.size();
      bodies.add(bar("left" + i, foot, left, 1));
      bodies.add(bar("right" + i, foot.plus(X), right, 1));
      bodies.add(bar("coupler" + i, left, right, 1));
      joints.add(turning("leftFoot" + i, BodyPoint.ROOT, first, foot, speed));
      joints.add(turning("rightFoot" + i, BodyPoint.ROOT, first + 1, foot.plus(X), speed));
      joints.add(turning("top" + i, first, first + 2, left, -speed));
      closures.add(
          new PointOnLineClosure(
              "window" + i,
              new BodyPoint(first + 2, right),
              new BodyPoint(first + 1, right),
              Y,
              Origin.NONE));
    }
    return mechanism("separate windows", bodies, joints, closures);
  }

  /**
   * Bars of 1 m around a regular polygon, the last side being the ground, hinged at its corners.
   */
  static Mechanism ring(int sides) {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    for (int i = 0; i < sides - 1; i++) {
      bodies.add(bar("bar" + i, corner(i, sides), corner(i + 1, sides), 1));
      int parent = i == 0 ? BodyPoint.ROOT : i - 1;
      joints.add(turning("hinge" + i, parent, i, corner(i, sides), 0));
    }
    Vector3 last = corner(sides - 1, sides);
    LoopClosure closed =
        new PointOnLineClosure(
            "closed",
            new BodyPoint(sides - 2, last),
            new BodyPoint(BodyPoint.ROOT, last),
            Y,
            Origin.NONE);
    return mechanism("ring", bodies, joints, List.of(closed));
  }

  private static Vector3 corner(int i, int sides) {
    double half = Math.PI / sides;
    double angle = (2 * i - 1) * half;
    double radius = 0.5 / Math.sin(half);
    return X.times(radius * Math.cos(angle)).plus(Z.times(radius * Math.sin(angle)));
  }

  private static Revolute turning(String name, int parent, int child, Vector3 at, double speed) {
    return new Revolute(
        name, new Attachment(parent, at, child, at, Rotation.IDENTITY), Y, 0, speed, Origin.NONE);
  }

  /** Two bars hanging level on ground side by side, related by closures. */
  static Mechanism twoPendulums(List<LoopClosure> closures) {
    List<Body> bodies = List.of(bar("left", Vector3.ZERO, X, 1), bar("right", Y, Y.plus(X), 2));
    List<Joint> joints =
        List.of(
            turning("leftHinge", BodyPoint.ROOT, 0, Vector3.ZERO, 0),
            turning("rightHinge", BodyPoint.ROOT, 1, Y, 0));
    return mechanism("two pendulums", bodies, joints, closures);
  }

  /** The four-bar of {@link #fourBar}, cut at D, its crank turning as a function of time. */
  static Mechanism drivenFourBar(double speed) {
    Mechanism free = fourBar(List.of(JointType.R, JointType.R, JointType.S, JointType.C), 3);
    return new Mechanism(
        "driven four-bar",
        GROUND,
        free.gravity(),
        free.bodies(),
        free.joints(),
        List.of(
            new PrescribedMotion(
                0, List.of(new Expression.Product(Expression.of(speed), new Expression.Time())))),
        free.startRoles(),
        free.closures(),
        List.of(),
        List.of());
  }

  /** The same linkage, cut at A, where a motion of the cut joint drives it. */
  static Mechanism fourBarDrivenAtCut(double speed) {
    Mechanism free = fourBar(List.of(JointType.R, JointType.R, JointType.S, JointType.C), 0);
    JointClosure cut = (JointClosure) free.closures().get(0);
    Expression angle = new Expression.Product(Expression.of(speed), new Expression.Time());
    LoopClosure driven = new JointClosure(cut.joint(), StartRole.PREFERRED, List.of(angle));
    return mechanism("driven at the cut", free.bodies(), free.joints(), List.of(driven));
  }

  /**
   * A body that slides and turns on an upright axis, on a thread or, without pitch, as closures
   * say.
   *
   * @param pitch m/rad; 0 for none
   */
  static Mechanism nut(List<LoopClosure> closures, double pitch) {
    Body nut = bar("nut", X.times(0.1), X.plus(Y), 2);
    Attachment at = between(BodyPoint.ROOT, 0);
    Joint joint =
        pitch == 0
            ? new Cylindrical("axis", at, Z, JointStart.atZero(JointType.C), Origin.NONE)
            : new Screw("axis", at, Z, pitch, 0, 0, Origin.NONE);
    return mechanism("nut", List.of(nut), List.of(joint), closures);
  }

  /** A slender bar between two points of the world, thickened so that it resists all turning. */
  static Body bar(String name, Vector3 from, Vector3 to, double mass) {
    Vector3 way = to.minus(from);
    double across = 1e-3 * mass;
    double along = mass / 12;
    InertiaTensor inertia =
        new InertiaTensor(
            along * (way.y() * way.y() + way.z() * way.z()) + across,
            along * (way.x() * way.x() + way.z() * way.z()) + across,
            along * (way.x() * way.x() + way.y() * way.y()) + across,
            -along * way.x() * way.y(),
            -along * way.x() * way.z(),
            -along * way.y() * way.z());
    return new Body(name, mass, from.plus(to).times(0.5), inertia, Origin.NONE);
  }

  static Revolute revolute(
      String name, int parent, Vector3 parentPoint, int child, Vector3 childPoint) {
    return new Revolute(
        name,
        new Attachment(parent, parentPoint, child, childPoint, Rotation.IDENTITY),
        Y.negated(),
        0,
        0,
        Origin.NONE);
  }
}
