package org.mechservice.mechml.resolve;

import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MessageCode;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.solver.mechanism.Attachment;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads point, {@code vector} and {@code vector2} of a joint that needs an axis in both bodies: A0
 * a2 = a1 with the least rotation, and with second vectors A0 b2 = b1 (MECHML §4).
 */
final class AxisReader {
  private final Diagnostics diagnostics;

  AxisReader(Diagnostics diagnostics) {
    this.diagnostics = diagnostics;
  }

  /** Returns how the joint sits; empty if something was wrong and has been reported. */
  Optional<AxisPlacement> read(JointInput input) {
    Optional<Vector3> point1 = input.end1().point();
    Optional<Vector3> point2 = input.end2().point();
    Optional<Vector3> axis1 = axis(input, input.end1());
    Optional<Vector3> axis2 = axis(input, input.end2());
    Optional<Rotation> zero =
        axis1.isPresent() && axis2.isPresent()
            ? zeroRotation(input, axis1.get(), axis2.get())
            : Optional.empty();
    if (point1.isEmpty() || point2.isEmpty() || axis1.isEmpty() || zero.isEmpty()) {
      return Optional.empty();
    }
    Attachment attachment =
        new Attachment(input.body1(), point1.get(), input.body2(), point2.get(), zero.get());
    return Optional.of(new AxisPlacement(attachment, axis1.get()));
  }

  private Optional<Vector3> axis(JointInput input, JointEnd end) {
    if (!end.has("vector")) {
      diagnostics.error(
          MessageCode.MISSING_VECTOR,
          end.element().place(),
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
    Optional<Rotation> least = ZeroRotation.least(axis2, axis1);
    if (least.isEmpty()) {
      error(
          MessageCode.OPPOSITE_VECTORS,
          input,
          "the vectors of the two bodies are opposite, which leaves open how the bodies stand at"
              + " zero; turn one round or add vector2 to both bodies");
    }
    return least;
  }

  private Optional<Rotation> withSecondVectors(JointInput input, Vector3 axis1, Vector3 axis2) {
    Optional<Vector3> second1 = input.end1().direction("vector2");
    Optional<Vector3> second2 = input.end2().direction("vector2");
    if (second1.isEmpty() || second2.isEmpty()) {
      return Optional.empty();
    }
    Optional<Rotation> rotation = ZeroRotation.aligned(axis2, second2.get(), axis1, second1.get());
    if (rotation.isEmpty()) {
      error(MessageCode.SECOND_VECTOR, input, "vector2 is parallel to vector");
    }
    return rotation;
  }

  private void error(MessageCode code, JointInput input, String message) {
    diagnostics.error(code, input.element().place(), input.element().label() + ": " + message);
  }
}
