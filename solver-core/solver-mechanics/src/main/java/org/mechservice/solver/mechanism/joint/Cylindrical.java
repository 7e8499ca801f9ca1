package org.mechservice.solver.mechanism.joint;

import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * The child slides along and turns about an axis fixed in both bodies: A = Rot(axis, q2) A0, the
 * child's point lies at q1 · axis from the parent's (docs/mechml.md#joints, type C).
 *
 * @param name name in the model file
 * @param attachment bodies, points, rotation at zero
 * @param axis unit vector in parent axes; positive motion of the child relative to the parent,
 *     right-handed
 * @param start displacement and angle, m and rad
 * @param origin position in the model file
 */
public record Cylindrical(
    String name, Attachment attachment, Vector3 axis, JointStart start, Origin origin)
    implements Joint {

  public Cylindrical {
    start.requireCounts(name, JointType.C);
  }

  @Override
  public JointType type() {
    return JointType.C;
  }

  @Override
  public List<Vector3> axes() {
    return List.of(axis);
  }

  /** {@inheritDoc} The axis is reversed, which keeps the sense of both coordinates. */
  @Override
  public Cylindrical reversed() {
    return new Cylindrical(
        name, attachment.reversed(), attachment.reversedAxis(axis), start, origin);
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
