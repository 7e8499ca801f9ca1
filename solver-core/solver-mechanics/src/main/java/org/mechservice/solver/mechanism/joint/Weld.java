package org.mechservice.solver.mechanism.joint;

import org.mechservice.solver.api.JointType;
import org.mechservice.solver.text.Origin;

/**
 * No motion: A = A0, the two points coincide (docs/mechml.md#joints, type W).
 *
 * @param name name in the model file
 * @param attachment bodies, points and relative orientation
 * @param origin position in the model file
 */
public record Weld(String name, Attachment attachment, Origin origin) implements Joint {

  @Override
  public JointType type() {
    return JointType.W;
  }

  @Override
  public Weld reversed() {
    return new Weld(name, attachment.reversed(), origin);
  }

  /** {@inheritDoc} There are none. */
  @Override
  public void initialPositions(double[] q, int offset) {}

  /** {@inheritDoc} There are none. */
  @Override
  public void initialVelocities(double[] v, int offset) {}
}
