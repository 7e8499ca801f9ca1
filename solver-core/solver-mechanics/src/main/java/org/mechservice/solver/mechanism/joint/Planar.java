package org.mechservice.solver.mechanism.joint;

import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * Two planes that slide on each other: with x and normal fixed in the file's body 1 and y = normal
 * × x, body 2's point lies at q1 x + q2 y from body 1's, and A = Rot(normal, q3) A0
 * (docs/mechml.md#joints, type PL).
 *
 * @param name name in the model file
 * @param attachment bodies, points, rotation at zero
 * @param normal unit vector in the axes of the file's body 1
 * @param direction unit vector x in the axes of the file's body 1, normal to {@code normal}
 * @param start two displacements and an angle, m and rad
 * @param fileBody2IsParent whether the tree leads from the file's body 2 to its body 1
 * @param origin position in the model file
 */
public record Planar(
    String name,
    Attachment attachment,
    Vector3 normal,
    Vector3 direction,
    JointStart start,
    boolean fileBody2IsParent,
    Origin origin)
    implements Joint {

  public Planar {
    start.requireCounts(name, JointType.PL);
  }

  @Override
  public JointType type() {
    return JointType.PL;
  }

  @Override
  public List<Vector3> axes() {
    return List.of(normal);
  }

  @Override
  public Planar reversed() {
    return new Planar(
        name, attachment.reversed(), normal, direction, start, !fileBody2IsParent, origin);
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
