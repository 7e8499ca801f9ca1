package org.mechservice.solver.kinematics;

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
 * The pose of the file's body 2 relative to its body 1, written out from docs/mechml.md#joints for
 * joints in the file's sense.
 *
 * @param rotation A, body 2 axes to body 1 axes
 * @param translation r, body 2's point from body 1's, in body 1 axes
 */
record JointDefinition(Rotation rotation, Vector3 translation) {

  static JointDefinition of(Joint joint, double[] q) {
    Rotation zero = joint.attachment().zeroRotation();
    return switch (joint.type()) {
      case R -> new JointDefinition(turned(((Revolute) joint).axis(), q[0], zero), Vector3.ZERO);
      case P -> new JointDefinition(zero, ((Prismatic) joint).axis().times(q[0]));
      case C -> {
        Vector3 axis = ((Cylindrical) joint).axis();
        yield new JointDefinition(turned(axis, q[1], zero), axis.times(q[0]));
      }
      case U -> {
        Universal cross = (Universal) joint;
        Rotation first = turned(cross.axis1(), q[0], zero);
        yield new JointDefinition(first.times(Rotation.about(cross.axis2(), q[1])), Vector3.ZERO);
      }
      case H -> {
        Screw screw = (Screw) joint;
        yield new JointDefinition(
            turned(screw.axis(), q[0], zero), screw.axis().times(screw.pitch() * q[0]));
      }
      case PL -> {
        Planar plane = (Planar) joint;
        Vector3 x = plane.direction();
        Vector3 y = plane.normal().cross(x);
        yield new JointDefinition(
            turned(plane.normal(), q[2], zero), x.times(q[0]).plus(y.times(q[1])));
      }
      case S -> new JointDefinition(euler(q), Vector3.ZERO);
      case F -> new JointDefinition(euler(q), new Vector3(q[4], q[5], q[6]));
      case W -> new JointDefinition(zero, Vector3.ZERO);
    };
  }

  private static Rotation turned(Vector3 axis, double angle, Rotation zero) {
    return Rotation.about(axis, angle).times(zero);
  }

  /** From the axis u and the angle φ that e = [cos(φ/2); u sin(φ/2)] stands for. */
  private static Rotation euler(double[] e) {
    Vector3 u = new Vector3(e[1], e[2], e[3]);
    return Rotation.about(u.normalized(), 2 * Math.atan2(u.norm(), e[0]));
  }
}
