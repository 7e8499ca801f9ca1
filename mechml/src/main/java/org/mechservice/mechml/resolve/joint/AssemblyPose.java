package org.mechservice.mechml.resolve.joint;

import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Cylindrical;
import org.mechservice.solver.mechanism.joint.Free;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Planar;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.Screw;
import org.mechservice.solver.mechanism.joint.Spherical;
import org.mechservice.solver.mechanism.joint.Universal;
import org.mechservice.solver.spatial.EulerParameters;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Where a body's frame is at assembly.
 *
 * @param origin the body's origin from that of the frame in which the pose is given, m
 * @param axes from the body's axes to those of that frame
 */
record AssemblyPose(Vector3 origin, Rotation axes) {
  /** The body's frame coincides with the other. */
  static final AssemblyPose COINCIDENT = new AssemblyPose(Vector3.ZERO, Rotation.IDENTITY);

  /**
   * Returns the pose of a joint's body2 as seen from its body1, at the start values of the joint:
   * the definitions of docs/mechml.md#joints.
   *
   * @param joint with body1 as parent
   */
  static AssemblyPose of(Joint joint) {
    double[] q = new double[joint.type().positionCount()];
    joint.initialPositions(q, 0);
    Attachment at = joint.attachment();
    Rotation zero = at.zeroRotation();
    Rotation turned = turned(joint, q, zero);
    Vector3 point = at.parentPoint().plus(slid(joint, q));
    return new AssemblyPose(point.minus(turned.apply(at.childPoint())), turned);
  }

  /** Returns A, from body2's axes to body1's. */
  private static Rotation turned(Joint joint, double[] q, Rotation zero) {
    if (joint instanceof Revolute revolute) {
      return Rotation.about(revolute.axis(), q[0]).times(zero);
    }
    if (joint instanceof Cylindrical cylindrical) {
      return Rotation.about(cylindrical.axis(), q[1]).times(zero);
    }
    if (joint instanceof Screw screw) {
      return Rotation.about(screw.axis(), q[0]).times(zero);
    }
    if (joint instanceof Planar planar) {
      return Rotation.about(planar.normal(), q[2]).times(zero);
    }
    if (joint instanceof Universal universal) {
      return Rotation.about(universal.axis1(), q[0])
          .times(zero)
          .times(Rotation.about(universal.axis2(), q[1]));
    }
    return joint instanceof Spherical || joint instanceof Free ? ofEulerParameters(q) : zero;
  }

  /** Returns r, from body1's point to body2's, in body1's axes. */
  private static Vector3 slid(Joint joint, double[] q) {
    if (joint instanceof Prismatic prismatic) {
      return prismatic.axis().times(q[0]);
    }
    if (joint instanceof Cylindrical cylindrical) {
      return cylindrical.axis().times(q[0]);
    }
    if (joint instanceof Screw screw) {
      return screw.axis().times(screw.pitch() * q[0]);
    }
    if (joint instanceof Planar planar) {
      return planar
          .direction()
          .times(q[0])
          .plus(planar.normal().cross(planar.direction()).times(q[1]));
    }
    return joint instanceof Free ? new Vector3(q[4], q[5], q[6]) : Vector3.ZERO;
  }

  private static Rotation ofEulerParameters(double[] e) {
    double[] r = new double[9];
    EulerParameters.rotation(e, 0, r, 0);
    return new Rotation(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]);
  }

  /** Returns the pose of a body that has this pose as seen from another body. */
  AssemblyPose from(AssemblyPose other) {
    return new AssemblyPose(other.origin.plus(other.axes.apply(origin)), other.axes.times(axes));
  }

  /** Returns the pose of the other body as seen from this one. */
  AssemblyPose reversed() {
    Rotation back = axes.transposed();
    return new AssemblyPose(back.apply(origin.negated()), back);
  }

  /** Returns the body's coordinates of a point. */
  Vector3 toBody(Vector3 point) {
    return axes.transposed().apply(point.minus(origin));
  }

  /** Returns the body's components of a direction. */
  Vector3 turnedToBody(Vector3 direction) {
    return axes.transposed().apply(direction);
  }

  /** Returns the rotation from another body's axes to this body's. */
  Rotation rotationFrom(AssemblyPose other) {
    return axes.equals(other.axes) ? Rotation.IDENTITY : axes.transposed().times(other.axes);
  }
}
