package org.mechservice.solver.mechanism.joint;

import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * The child turns about an axis fixed in both bodies: A = Rot(axis, q) A0, the two points coincide
 * (docs/mechml.md#joints, type R).
 *
 * @param name name in the model file
 * @param attachment bodies, points, rotation at zero
 * @param axis unit vector in parent axes; positive motion of the child relative to the parent,
 *     right-handed
 * @param initialPosition angle at the start, rad
 * @param initialVelocity its rate at the start, rad/s
 * @param origin position in the model file
 */
public record Revolute(
    String name,
    Attachment attachment,
    Vector3 axis,
    double initialPosition,
    double initialVelocity,
    Origin origin)
    implements Joint {

  @Override
  public JointType type() {
    return JointType.R;
  }

  @Override
  public List<Vector3> axes() {
    return List.of(axis);
  }

  /** {@inheritDoc} The axis is reversed, which keeps the sense of the coordinate. */
  @Override
  public Revolute reversed() {
    return new Revolute(
        name,
        attachment.reversed(),
        attachment.reversedAxis(axis),
        initialPosition,
        initialVelocity,
        origin);
  }

  @Override
  public void initialPositions(double[] q, int offset) {
    q[offset] = initialPosition;
  }

  @Override
  public void initialVelocities(double[] v, int offset) {
    v[offset] = initialVelocity;
  }
}
