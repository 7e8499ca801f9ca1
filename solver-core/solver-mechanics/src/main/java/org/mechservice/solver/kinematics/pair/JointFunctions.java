package org.mechservice.solver.kinematics.pair;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.mechservice.solver.mechanism.joint.Cylindrical;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Planar;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.Screw;
import org.mechservice.solver.mechanism.joint.Universal;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * The constraint functions and coordinates of a joint, as functions of the pose of the file's body
 * 2 (B) relative to its body 1 (A), by the definitions of docs/mechml.md#joints. The constraint
 * functions are smooth, free of Euler parameters, and zero only in poses of the joint.
 *
 * @param forbidden constraint functions, zero in every pose that the joint allows; 6 minus its
 *     degrees of freedom
 * @param coordinates one per velocity: the coordinate it is the rate of, or a component of angular
 *     velocity in joints with Euler parameters
 */
record JointFunctions(List<PairFunction> forbidden, List<PairFunction> coordinates) {
  private static final Vector3 X = new Vector3(1, 0, 0);
  private static final Vector3 Y = new Vector3(0, 1, 0);
  private static final Vector3 Z = new Vector3(0, 0, 1);

  /**
   * Returns the functions of a joint.
   *
   * @param zero rotation of body 2 relative to body 1 at zero
   */
  static JointFunctions of(Joint joint, Rotation zero) {
    return switch (joint.type()) {
      case R -> revolute((Revolute) joint, zero);
      case P -> prismatic((Prismatic) joint, zero);
      case C -> cylindrical((Cylindrical) joint, zero);
      case H -> screw((Screw) joint, zero);
      case PL -> planar((Planar) joint, zero);
      case U -> universal((Universal) joint, zero);
      case S -> new JointFunctions(displacements(X, Y, Z), angularVelocities());
      case F -> free();
      case W -> new JointFunctions(weld(zero), List.of());
    };
  }

  private static JointFunctions revolute(Revolute joint, Rotation zero) {
    Frame frame = new Frame(joint.axis(), zero);
    List<PairFunction> forbidden = displacements(frame.b, frame.c, frame.a);
    forbidden.addAll(frame.tilts());
    return new JointFunctions(forbidden, List.of(frame.turn()));
  }

  private static JointFunctions prismatic(Prismatic joint, Rotation zero) {
    Frame frame = new Frame(joint.axis(), zero);
    List<PairFunction> forbidden = displacements(frame.b, frame.c);
    forbidden.addAll(rotations(zero));
    return new JointFunctions(forbidden, List.of(new Displacement("way", joint.axis())));
  }

  private static JointFunctions cylindrical(Cylindrical joint, Rotation zero) {
    Frame frame = new Frame(joint.axis(), zero);
    List<PairFunction> forbidden = displacements(frame.b, frame.c);
    forbidden.addAll(frame.tilts());
    return new JointFunctions(
        forbidden, List.of(new Displacement("way", joint.axis()), frame.turn()));
  }

  private static JointFunctions screw(Screw joint, Rotation zero) {
    Frame frame = new Frame(joint.axis(), zero);
    List<PairFunction> forbidden = displacements(frame.b, frame.c);
    forbidden.addAll(frame.tilts());
    forbidden.add(
        new ScrewGap(
            "way along the thread",
            new Displacement("", joint.axis()),
            frame.turn(),
            joint.pitch()));
    return new JointFunctions(forbidden, List.of(frame.turn()));
  }

  private static JointFunctions planar(Planar joint, Rotation zero) {
    Frame frame = new Frame(joint.normal(), joint.direction(), zero);
    List<PairFunction> forbidden = displacements(joint.normal());
    forbidden.addAll(frame.tilts());
    return new JointFunctions(
        forbidden,
        List.of(new Displacement("x", frame.b), new Displacement("y", frame.c), frame.turn()));
  }

  /**
   * Returns the functions of a universal joint: axis 2, fixed in body 2, rotates about axis 1, and
   * axis 1, seen from body 2, about axis 2; the angle between the axes is constant.
   */
  private static JointFunctions universal(Universal joint, Rotation zero) {
    Vector3 axis1 = joint.axis1();
    Vector3 axis2 = joint.axis2();
    Vector3 axis2AtZero = zero.apply(axis2);
    Vector3 axis1InB = zero.transposed().apply(axis1);
    List<PairFunction> forbidden = displacements(X, Y, Z);
    forbidden.add(new AxisCosine("angle of the axes", axis1, axis2, axis1.dot(axis2AtZero)));
    PairFunction first =
        new Turn(
            "angle about axis 1",
            new AxisProduct(axis1.cross(axis2AtZero).normalized(), axis2),
            new AxisProduct(axis1.cross(axis2AtZero).cross(axis1).normalized(), axis2),
            1);
    PairFunction second =
        new Turn(
            "angle about axis 2",
            new AxisProduct(axis1, axis2.cross(axis1InB).normalized()),
            new AxisProduct(axis1, axis2.cross(axis1InB).cross(axis2).normalized()),
            -1);
    return new JointFunctions(forbidden, List.of(first, second));
  }

  private static JointFunctions free() {
    List<PairFunction> coordinates = angularVelocities();
    coordinates.addAll(displacements(X, Y, Z));
    return new JointFunctions(List.of(), coordinates);
  }

  private static List<PairFunction> weld(Rotation zero) {
    List<PairFunction> forbidden = displacements(X, Y, Z);
    forbidden.addAll(rotations(zero));
    return forbidden;
  }

  private static List<PairFunction> displacements(Vector3... axes) {
    List<PairFunction> displacements = new ArrayList<>();
    for (Vector3 axis : axes) {
      displacements.add(new Displacement("displacement along " + text(axis), axis));
    }
    return displacements;
  }

  /** Returns functions that are zero if body 2 has a given orientation relative to body 1. */
  static List<PairFunction> rotations(Rotation zero) {
    Vector3[] axes = {X, Y, Z};
    Rotation toB = zero.transposed();
    List<PairFunction> rotations = new ArrayList<>();
    for (int k = 0; k < 3; k++) {
      rotations.add(Tilt.ofFrame("rotation about " + text(axes[k]), axes, k, toB));
    }
    return rotations;
  }

  private static List<PairFunction> angularVelocities() {
    List<PairFunction> components = new ArrayList<>();
    for (int axis = 0; axis < 3; axis++) {
      components.add(new AngularVelocityComponent("angular velocity", axis));
    }
    return components;
  }

  private static String text(Vector3 axis) {
    return String.format(Locale.ROOT, "(%.4g, %.4g, %.4g)", axis.x(), axis.y(), axis.z());
  }

  /** A common axis a of both bodies, with normals b and c = a × b in A and their images in B. */
  private static final class Frame {
    final Vector3 a;
    final Vector3 b;
    final Vector3 c;
    private final Rotation toB;

    Frame(Vector3 axis, Rotation zero) {
      this(axis, normalTo(axis), zero);
    }

    Frame(Vector3 axis, Vector3 normal, Rotation zero) {
      a = axis;
      b = normal;
      c = axis.cross(normal);
      toB = zero.transposed();
    }

    List<PairFunction> tilts() {
      Vector3 axisInB = toB.apply(a);
      // leaning along c is a rotation about −b: the label names the rotation
      return List.of(
          Tilt.ofAxis("tilt about " + text(b), a, c, axisInB),
          Tilt.ofAxis("tilt about " + text(c), a, b, axisInB));
    }

    Turn turn() {
      Vector3 normalInB = toB.apply(b);
      return new Turn("angle", new AxisProduct(c, normalInB), new AxisProduct(b, normalInB), 1);
    }
  }

  /**
   * Returns the unit vector normal to a unit vector and to the coordinate axis it is least along.
   */
  static Vector3 normalTo(Vector3 axis) {
    double x = Math.abs(axis.x());
    double y = Math.abs(axis.y());
    double z = Math.abs(axis.z());
    if (x <= y && x <= z) {
      return axis.cross(X).normalized();
    }
    return axis.cross(y <= z ? Y : Z).normalized();
  }
}
