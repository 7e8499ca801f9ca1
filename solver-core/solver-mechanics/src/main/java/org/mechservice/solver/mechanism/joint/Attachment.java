package org.mechservice.solver.mechanism.joint;

import org.mechservice.solver.api.JointType;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * The two bodies that a joint connects, and their relative pose at zero coordinates.
 *
 * @param parent index of the body nearer the root in the list of bodies; −1 for the root
 * @param parentPoint the joint's point on the parent, from the parent's origin, in parent axes, m
 * @param child index of the outer body in the list of bodies
 * @param childPoint the joint's point on the child, from the child's origin, in child axes, m
 * @param zeroRotation from child axes to parent axes at zero coordinates (A0 in
 *     docs/mechml.md#joints)
 */
public record Attachment(
    int parent, Vector3 parentPoint, int child, Vector3 childPoint, Rotation zeroRotation) {

  /** Returns the same attachment seen from the child. */
  public Attachment reversed() {
    return new Attachment(child, childPoint, parent, parentPoint, zeroRotation.transposed());
  }

  /**
   * Returns the axis of the joint with parent and child exchanged and the sense of motion kept: the
   * opposite vector, in child axes.
   *
   * @param axis unit vector in parent axes
   */
  Vector3 reversedAxis(Vector3 axis) {
    return zeroRotation.transposed().apply(axis).negated();
  }

  /**
   * Rejects a rotation at zero for joints whose coordinates are Euler parameters.
   *
   * @throws IllegalArgumentException naming the joint
   */
  void requireParallelAtZero(String joint, JointType type) {
    if (!zeroRotation.equals(Rotation.IDENTITY)) {
      throw new IllegalArgumentException(
          "joint "
              + joint
              + " of type "
              + type
              + " has parallel axes at zero; give its rotation by"
              + " its Euler parameters");
    }
  }
}
