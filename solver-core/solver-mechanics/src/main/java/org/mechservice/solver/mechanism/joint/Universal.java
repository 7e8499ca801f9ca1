package org.mechservice.solver.mechanism.joint;

import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * A cross rotates about an axis of the file's body 1, and body 2 rotates about its own axis
 * relative to the cross: A = Rot(axis1, q1) A0 Rot(axis2, q2), the two points coincide
 * (docs/mechml.md#joints, type U).
 *
 * @param name name in the model file
 * @param attachment bodies, points, rotation at zero
 * @param axis1 unit vector in the axes of the file's body 1
 * @param axis2 unit vector in the axes of the file's body 2
 * @param start the two angles, rad
 * @param fileBody2IsParent whether the tree takes the joint from the file's body 2 to its body 1
 * @param origin position in the model file
 */
public record Universal(
    String name,
    Attachment attachment,
    Vector3 axis1,
    Vector3 axis2,
    JointStart start,
    boolean fileBody2IsParent,
    Origin origin)
    implements Joint {

  public Universal {
    start.requireCounts(name, JointType.U);
  }

  @Override
  public JointType type() {
    return JointType.U;
  }

  @Override
  public List<Vector3> axes() {
    return List.of(axis1, axis2);
  }

  @Override
  public Universal reversed() {
    return new Universal(
        name, attachment.reversed(), axis1, axis2, start, !fileBody2IsParent, origin);
  }

  @Override
  public void initialPositions(double[] q, int offset) {
    start.writePositions(q, offset);
  }

  @Override
  public void initialVelocities(double[] v, int offset) {
    start.writeVelocities(v, offset);
  }
}
