package org.mechservice.solver.mechanism.joint;

import org.mechservice.solver.api.JointType;
import org.mechservice.solver.text.Origin;

/**
 * A ball and socket: the two points coincide, A = R(e) with e the Euler parameters of the file's
 * body 2 relative to its body 1; the velocities are the angular velocity of body 2 relative to body
 * 1 in body 1's axes (docs/mechml.md#joints, type S).
 *
 * @param name name in the model file
 * @param attachment bodies and points; the rotation at zero is the identity, since e = (1, 0, 0, 0)
 *     means parallel axes
 * @param start Euler parameters, and angular velocity in rad/s
 * @param fileBody2IsParent whether the tree leads from the file's body 2 to its body 1
 * @param origin position in the model file
 */
public record Spherical(
    String name, Attachment attachment, JointStart start, boolean fileBody2IsParent, Origin origin)
    implements Joint {

  public Spherical {
    start.requireCounts(name, JointType.S);
    attachment.requireParallelAtZero(name, JointType.S);
  }

  @Override
  public JointType type() {
    return JointType.S;
  }

  @Override
  public Spherical reversed() {
    return new Spherical(name, attachment.reversed(), start, !fileBody2IsParent, origin);
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
