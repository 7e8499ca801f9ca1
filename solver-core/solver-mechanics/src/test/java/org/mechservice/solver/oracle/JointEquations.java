package org.mechservice.solver.oracle;

import java.util.List;
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
 * The definitions of docs/mechml.md#joints: what motion coordinates give, and what is zero whatever
 * they are. Poses are those of the file's body 2 from body 1, in body 1's axes.
 */
final class JointEquations {
  private JointEquations() {}

  /**
   * Returns how the coordinates move at given velocities and accelerations.
   *
   * @param at where the joint's positions begin in q
   * @param vAt where its velocities begin in v and a
   */
  static Taylor[] coordinates(Joint joint, double[] q, int at, double[] v, double[] a, int vAt) {
    Taylor[] moving = new Taylor[joint.type().positionCount()];
    if (!joint.type().hasEulerParameters()) {
      for (int i = 0; i < moving.length; i++) {
        moving[i] = new Taylor(q[at + i], v[vAt + i], a[vAt + i]);
      }
      return moving;
    }
    // e' = ½ (0, ω) ∘ e
    Vector3 e = new Vector3(q[at + 1], q[at + 2], q[at + 3]);
    Vector3 omega = new Vector3(v[vAt], v[vAt + 1], v[vAt + 2]);
    Vector3 alpha = new Vector3(a[vAt], a[vAt + 1], a[vAt + 2]);
    double e0d = -0.5 * omega.dot(e);
    Vector3 ed = omega.times(q[at]).plus(omega.cross(e)).times(0.5);
    double e0dd = -0.5 * (alpha.dot(e) + omega.dot(ed));
    Vector3 edd =
        alpha.times(q[at]).plus(alpha.cross(e)).plus(omega.times(e0d)).plus(omega.cross(ed));
    moving[0] = new Taylor(q[at], e0d, e0dd);
    TaylorVector vector = TaylorVector.of(e, ed, edd.times(0.5));
    moving[1] = vector.x();
    moving[2] = vector.y();
    moving[3] = vector.z();
    for (int i = 4; i < moving.length; i++) {
      moving[i] = new Taylor(q[at + i], v[vAt + i - 1], a[vAt + i - 1]);
    }
    return moving;
  }

  /** Returns the pose that coordinates give. */
  static TaylorPose pose(Joint joint, Taylor[] q) {
    TaylorRotation zero = TaylorRotation.of(JointSide.of(joint).zero());
    TaylorVector none = TaylorVector.ZERO;
    return switch (joint.type()) {
      case R ->
          new TaylorPose(none, TaylorRotation.about(((Revolute) joint).axis(), q[0]).times(zero));
      case P -> new TaylorPose(along(((Prismatic) joint).axis(), q[0]), zero);
      case C -> {
        Vector3 axis = ((Cylindrical) joint).axis();
        yield new TaylorPose(along(axis, q[0]), TaylorRotation.about(axis, q[1]).times(zero));
      }
      case H -> {
        Screw h = (Screw) joint;
        yield new TaylorPose(
            along(h.axis(), q[0].times(h.pitch())),
            TaylorRotation.about(h.axis(), q[0]).times(zero));
      }
      case PL -> {
        Planar p = (Planar) joint;
        Vector3 y = p.normal().cross(p.direction());
        yield new TaylorPose(
            along(p.direction(), q[0]).plus(along(y, q[1])),
            TaylorRotation.about(p.normal(), q[2]).times(zero));
      }
      case U -> {
        Universal u = (Universal) joint;
        TaylorRotation first = TaylorRotation.about(u.axis1(), q[0]);
        yield new TaylorPose(none, first.times(zero).times(TaylorRotation.about(u.axis2(), q[1])));
      }
      case S -> new TaylorPose(none, turned(q));
      case F -> new TaylorPose(new TaylorVector(q[4], q[5], q[6]), turned(q));
      case W -> new TaylorPose(none, zero);
    };
  }

  private static TaylorRotation turned(Taylor[] q) {
    return TaylorRotation.ofEulerParameters(q[0], new TaylorVector(q[1], q[2], q[3]));
  }

  private static TaylorVector along(Vector3 axis, Taylor way) {
    return TaylorVector.of(axis).times(way);
  }

  /**
   * Returns a coordinate that a pose has: of R, P or C, angles within half a turn.
   *
   * @param component which, in the order of docs/mechml.md#joints
   */
  static Taylor coordinate(Joint joint, int component, TaylorPose pose) {
    if (joint instanceof Prismatic p) {
      return pose.position().dot(p.axis());
    }
    if (joint instanceof Cylindrical c && component == 0) {
      return pose.position().dot(c.axis());
    }
    if (joint instanceof Cylindrical || joint instanceof Revolute) {
      Vector3 b = normalTo(joint.axes().get(0));
      Rotation zero = JointSide.of(joint).zero();
      TaylorVector turned = pose.rotation().times(TaylorRotation.of(zero).transposed()).apply(b);
      return Taylor.angle(turned.dot(joint.axes().get(0).cross(b)), turned.dot(b));
    }
    throw new IllegalArgumentException("the oracle cannot read " + joint.name() + " from a pose");
  }

  /** Returns what is zero in every pose the joint allows. */
  static List<Taylor> conditions(Joint joint, TaylorPose pose) {
    TaylorVector r = pose.position();
    Rotation zero = JointSide.of(joint).zero();
    TaylorRotation turned = pose.rotation().times(TaylorRotation.of(zero).transposed());
    return switch (joint.type()) {
      case F -> List.of();
      case S -> List.of(r.x(), r.y(), r.z());
      case U -> {
        // axis 1 and axis 2 keep the angle between them
        Universal u = (Universal) joint;
        Taylor cosine = pose.rotation().apply(u.axis2()).dot(u.axis1());
        double atZero = zero.apply(u.axis2()).dot(u.axis1());
        yield List.of(r.x(), r.y(), r.z(), cosine.minus(Taylor.of(atZero)));
      }
      case P -> {
        Vector3 axis = ((Prismatic) joint).axis();
        Vector3 b = normalTo(axis);
        yield List.of(
            r.dot(b), r.dot(axis.cross(b)), turned.y().z(), turned.z().x(), turned.x().y());
      }
      case R, C, H -> aboutAxis(joint, r, turned);
      case PL -> {
        Planar p = (Planar) joint;
        TaylorVector normal = turned.apply(p.normal());
        yield List.of(
            r.dot(p.normal()),
            normal.dot(p.direction()),
            normal.dot(p.normal().cross(p.direction())));
      }
      case W -> List.of(r.x(), r.y(), r.z(), turned.y().z(), turned.z().x(), turned.x().y());
    };
  }

  /** Returns what is zero when a pose is the given one. */
  static List<Taylor> differences(TaylorPose pose, TaylorPose given) {
    TaylorVector r = pose.position().minus(given.position());
    TaylorRotation turned = pose.rotation().times(given.rotation().transposed());
    return List.of(r.x(), r.y(), r.z(), turned.y().z(), turned.z().x(), turned.x().y());
  }

  private static List<Taylor> aboutAxis(Joint joint, TaylorVector r, TaylorRotation turned) {
    Vector3 axis = joint.axes().get(0);
    Vector3 b = normalTo(axis);
    Vector3 c = axis.cross(b);
    TaylorVector carried = turned.apply(axis);
    Taylor first = carried.dot(b);
    Taylor second = carried.dot(c);
    if (joint instanceof Revolute) {
      return List.of(r.x(), r.y(), r.z(), first, second);
    }
    if (joint instanceof Screw h) {
      TaylorVector turnedB = turned.apply(b);
      Taylor angle = Taylor.angle(turnedB.dot(c), turnedB.dot(b));
      // whole turns do not change the rotation
      Taylor gap = r.dot(axis).times(1 / h.pitch()).minus(angle);
      Taylor whole = Taylor.of(2 * Math.PI * Math.rint(gap.x() / (2 * Math.PI)));
      return List.of(r.dot(b), r.dot(c), first, second, gap.minus(whole).times(h.pitch()));
    }
    return List.of(r.dot(b), r.dot(c), first, second);
  }

  /** Returns a unit vector normal to a unit vector. */
  static Vector3 normalTo(Vector3 axis) {
    Vector3 least = new Vector3(1, 0, 0);
    if (Math.abs(axis.y()) < Math.abs(axis.x()) && Math.abs(axis.y()) <= Math.abs(axis.z())) {
      least = new Vector3(0, 1, 0);
    } else if (Math.abs(axis.z()) < Math.abs(axis.x())) {
      least = new Vector3(0, 0, 1);
    }
    return axis.cross(least).normalized();
  }
}
