package org.mechservice.solver.oracle;

import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/** Bodies and points of a joint as the file orders them: body 2 moves relative to body 1. */
record JointSide(int body1, Vector3 point1, int body2, Vector3 point2, Rotation zero) {
  static JointSide of(Joint joint) {
    Attachment at = joint.attachment();
    return joint.fileBody2IsParent()
        ? new JointSide(
            at.child(),
            at.childPoint(),
            at.parent(),
            at.parentPoint(),
            at.zeroRotation().transposed())
        : new JointSide(
            at.parent(), at.parentPoint(), at.child(), at.childPoint(), at.zeroRotation());
  }

  /** Pose of body 2's joint point and axes from body 1's joint point, in body 1's axes. */
  TaylorPose relative(TaylorPose pose1, TaylorPose pose2) {
    TaylorVector between = pose2.at(point2).minus(pose1.at(point1));
    return new TaylorPose(
        pose1.rotation().applyTransposed(between),
        pose1.rotation().transposed().times(pose2.rotation()));
  }
}
