package org.mechservice.solver.mechanism.joint;

import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * The child turns about an axis fixed in both bodies and moves along it as a nut on a screw: A =
 * Rot(axis, q) A0, the child's point lies at pitch · q · axis from the parent's
 * (docs/mechml.md#joints, type H).
 *
 * @param name name in the model file
 * @param attachment bodies, points, rotation at zero
 * @param axis unit vector in parent axes; positive motion of the child relative to the parent,
 *     right-handed
 * @param pitch displacement along the axis per angle, m/rad; negative for a left-handed screw
 * @param initialPosition angle at the start, rad
 * @param initialVelocity its rate at the start, rad/s
 * @param origin position in the model file
 */
public record Screw(
    String name,
    Attachment attachment,
    Vector3 axis,
    double pitch,
    double initialPosition,
    double initialVelocity,
    Origin origin)
    implements Joint {

  @Override
  public JointType type() {
    return JointType.H;
  }

  @Override
  public List<Vector3> axes() {
    return List.of(axis);
  }

  /** {@inheritDoc} The axis is reversed, which keeps the sense of coordinate and pitch. */
  @Override
  public Screw reversed() {
    return new Screw(
        name,
        attachment.reversed(),
        attachment.reversedAxis(axis),
        pitch,
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
