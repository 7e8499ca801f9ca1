package org.mechservice.solver.mechanism.joint;

import org.mechservice.solver.api.JointType;
import org.mechservice.solver.text.Origin;

/**
 * No constraint: q = e0, e1, e2, e3, x, y, z with e the Euler parameters of the file's body 2
 * relative to its body 1 and x, y, z the position of body 2's point from body 1's in body 1's axes;
 * v = angular velocity of body 2 relative to body 1 and d(x, y, z)/dt as seen from body 1, both in
 * body 1's axes (docs/mechml.md#joints, type F).
 *
 * @param name name in the model file
 * @param attachment bodies and points; the rotation at zero is the identity, since e = (1, 0, 0, 0)
 *     means parallel axes
 * @param start Euler parameters and position in m; angular velocity in rad/s and velocity in m/s
 * @param fileBody2IsParent whether the tree leads from the file's body 2 to its body 1
 * @param origin position in the model file
 */
public record Free(
    String name, Attachment attachment, JointStart start, boolean fileBody2IsParent, Origin origin)
    implements Joint {

  public Free {
    start.requireCounts(name, JointType.F);
    attachment.requireParallelAtZero(name, JointType.F);
  }

  @Override
  public JointType type() {
    return JointType.F;
  }

  @Override
  public Free reversed() {
    return new Free(name, attachment.reversed(), start, !fileBody2IsParent, origin);
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
