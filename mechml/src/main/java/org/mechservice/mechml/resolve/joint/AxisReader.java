package org.mechservice.mechml.resolve.joint;

import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.resolve.body.AlignmentRotation;
import org.mechservice.mechml.resolve.body.BodyEnd;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads the points and vectors of joints and computes the relative orientation of the bodies at
 * zero (docs/mechml.md#joints). In the formulas a1, a2 are the vectors and b1, b2 the second
 * vectors.
 */
final class AxisReader {
  private final Diagnostics diagnostics;

  AxisReader(Diagnostics diagnostics) {
    this.diagnostics = diagnostics;
  }

  /**
   * Returns the placement of a joint with one axis: A0 a2 = a1 with the least rotation, and with
   * second vectors A0 b2 = b1; empty after a reported error.
   */
  Optional<Placement> read(JointInput input) {
    Optional<Vector3> axis1 = axis(input, input.end1());
    Optional<Vector3> axis2 = axis(input, input.end2());
    Optional<Rotation> zero =
        axis1.isPresent() && axis2.isPresent()
            ? zeroRotation(input, axis1.get(), axis2.get())
            : Optional.empty();
    return placement(input, axis1, axis2, zero);
  }

  /**
   * Returns the placement of a planar joint: as {@link #read}, but body1 needs its second vector,
   * and body2 may omit it.
   */
  Optional<Placement> readPlane(JointInput input) {
    Optional<Vector3> axis1 = axis(input, input.end1());
    Optional<Vector3> axis2 = axis(input, input.end2());
    if (!input.end1().has("vector2")) {
      error(
          MessageCode.SECOND_VECTOR,
          input,
          "body1 needs vector2, the direction of the first displacement");
      return Optional.empty();
    }
    Optional<Vector3> second = axis1.flatMap(axis -> secondDirection(input, axis));
    if (axis1.isEmpty() || axis2.isEmpty() || second.isEmpty()) {
      return Optional.empty();
    }
    Optional<Rotation> zero =
        input.end2().has("vector2")
            ? withSecondVectors(input, axis1.get(), axis2.get())
            : leastRotation(input, axis1.get(), axis2.get());
    return placement(input, axis1, axis2, zero)
        .map(at -> new Placement(at.attachment(), at.axis1(), at.axis2(), second.get()));
  }

  /** Returns b1, orthogonal to a1 and of length 1; empty after a reported error. */
  private Optional<Vector3> secondDirection(JointInput input, Vector3 axis1) {
    Optional<Vector3> second = input.end1().direction("vector2");
    if (second.isPresent() && AlignmentRotation.areParallel(axis1, second.get())) {
      error(MessageCode.SECOND_VECTOR, input, "vector2 is parallel to vector");
      return Optional.empty();
    }
    return second.map(direction -> AlignmentRotation.normalTo(axis1, direction));
  }

  /**
   * Returns the placement of a universal joint: A0 is the least rotation that brings a2 into the
   * plane normal to a1, or onto b1.
   */
  Optional<Placement> readCross(JointInput input) {
    Optional<Vector3> axis1 = axis(input, input.end1());
    Optional<Vector3> axis2 = axis(input, input.end2());
    if (axis1.isEmpty() || axis2.isEmpty()) {
      return Optional.empty();
    }
    return placement(input, axis1, axis2, crossRotation(input, axis1.get(), axis2.get()));
  }

  private Optional<Rotation> crossRotation(JointInput input, Vector3 axis1, Vector3 axis2) {
    if (input.end2().has("vector2")) {
      error(
          MessageCode.SECOND_VECTOR,
          input,
          "body2 must not have vector2; vector2 of body1 gives the direction of body2's vector at"
              + " zero");
      return Optional.empty();
    }
    if (input.end1().has("vector2")) {
      return secondDirection(input, axis1)
          .flatMap(direction -> leastRotation(input, direction, axis2));
    }
    if (AlignmentRotation.areParallel(axis1, axis2)) {
      error(
          MessageCode.SECOND_VECTOR,
          input,
          "the vectors of the two bodies are parallel, so the direction of the second axis at zero"
              + " is not defined; add vector2 to body1");
      return Optional.empty();
    }
    return AlignmentRotation.areOrthogonal(axis1, axis2)
        ? Optional.of(Rotation.IDENTITY)
        : AlignmentRotation.least(axis2, AlignmentRotation.normalTo(axis1, axis2));
  }

  /**
   * Returns the placement of a weld: as {@link #read}, with parallel axes if there are no vectors.
   */
  Optional<Placement> readWeld(JointInput input) {
    if (input.end1().has("vector") || input.end2().has("vector")) {
      return read(input);
    }
    return readPoints(input);
  }

  /** Returns the placement of a joint without axes, with parallel body axes at zero. */
  Optional<Placement> readPoints(JointInput input) {
    refuseVectors(input, input.end1());
    refuseVectors(input, input.end2());
    return placement(
        input,
        Optional.of(Vector3.ZERO),
        Optional.of(Vector3.ZERO),
        Optional.of(Rotation.IDENTITY));
  }

  private void refuseVectors(JointInput input, BodyEnd end) {
    if (end.has("vector") || end.has("vector2")) {
      diagnostics.error(
          MessageCode.VECTOR_WITHOUT_MEANING,
          end.element().position(),
          Phrase.of(
              input.type().name().equals("W")
                  ? "%s names vector2 but no vector"
                  : "%s names a vector; a joint of type %s has none: the axes of its bodies are"
                      + " parallel if its Euler parameters are 1;0;0;0",
              end.element().role(),
              input.type()));
    }
  }

  private static Optional<Placement> placement(
      JointInput input, Optional<Vector3> axis1, Optional<Vector3> axis2, Optional<Rotation> zero) {
    Optional<Vector3> point1 = input.end1().point();
    Optional<Vector3> point2 = input.end2().point();
    if (point1.isEmpty() || point2.isEmpty() || axis1.isEmpty() || zero.isEmpty()) {
      return Optional.empty();
    }
    Attachment attachment =
        new Attachment(input.body1(), point1.get(), input.body2(), point2.get(), zero.get());
    return Optional.of(new Placement(attachment, axis1.get(), axis2.orElseThrow(), Vector3.ZERO));
  }

  private Optional<Vector3> axis(JointInput input, BodyEnd end) {
    if (!end.has("vector")) {
      diagnostics.error(
          MessageCode.MISSING_VECTOR,
          end.element().position(),
          Phrase.of(
              "%s names no vector; a joint of type %s needs one in both bodies",
              end.element().role(), input.element().required("type")));
    }
    return end.direction("vector");
  }

  private Optional<Rotation> zeroRotation(JointInput input, Vector3 axis1, Vector3 axis2) {
    boolean second1 = input.end1().has("vector2");
    boolean second2 = input.end2().has("vector2");
    if (second1 && second2) {
      return withSecondVectors(input, axis1, axis2);
    }
    if (second1 || second2) {
      error(MessageCode.SECOND_VECTOR, input, "vector2 must be given in both bodies or in neither");
      return Optional.empty();
    }
    return leastRotation(input, axis1, axis2);
  }

  private Optional<Rotation> leastRotation(JointInput input, Vector3 to, Vector3 from) {
    Optional<Rotation> least = AlignmentRotation.least(from, to);
    if (least.isEmpty()) {
      error(
          MessageCode.OPPOSITE_VECTORS,
          input,
          "the vectors of the two bodies are opposite, so the relative orientation at zero is not"
              + " defined; reverse one vector or add vector2 to both bodies");
    }
    return least;
  }

  private Optional<Rotation> withSecondVectors(JointInput input, Vector3 axis1, Vector3 axis2) {
    Optional<Vector3> second1 = input.end1().direction("vector2");
    Optional<Vector3> second2 = input.end2().direction("vector2");
    if (second1.isEmpty() || second2.isEmpty()) {
      return Optional.empty();
    }
    Optional<Rotation> rotation =
        AlignmentRotation.aligned(axis2, second2.get(), axis1, second1.get());
    if (rotation.isEmpty()) {
      error(MessageCode.SECOND_VECTOR, input, "vector2 is parallel to vector");
    }
    return rotation;
  }

  private void error(MessageCode code, JointInput input, String message) {
    diagnostics.error(code, input.element().position(), input.element().label() + ": " + message);
  }

  /**
   * Placement of a joint in its two bodies.
   *
   * @param attachment points, and the rotation at zero
   * @param axis1 unit vector in body1's axes; zero for a joint without axes
   * @param axis2 unit vector in body2's axes; zero for a joint without axes
   * @param second direction of a planar joint's first displacement, a unit vector in body1's axes
   *     at right angles to axis1; without meaning in others
   */
  record Placement(Attachment attachment, Vector3 axis1, Vector3 axis2, Vector3 second) {}
}
