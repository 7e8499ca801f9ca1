package org.mechservice.mechml.resolve.formula;

import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.body.AlignmentRotation;
import org.mechservice.mechml.resolve.body.BodyEnd;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads frames fixed in bodies: {@code vector} is the z axis, {@code vector2} gives the x axis, its
 * part normal to z. Without vectors the axes are the body's; with {@code vector} alone they are
 * turned from the body's by the least rotation.
 */
public final class FrameReader {
  private static final Vector3 Z = new Vector3(0, 0, 1);

  private final MechanismNames names;
  private final Diagnostics diagnostics;

  public FrameReader(MechanismNames names, Diagnostics diagnostics) {
    this.names = names;
    this.diagnostics = diagnostics;
  }

  /** Returns the frame of an end; empty after a reported error. */
  public Optional<BodyFrame> read(Element element) {
    Optional<BodyPoint> point = names.point(element);
    Optional<Rotation> axes = names.end(element).flatMap(this::axes);
    return point.isPresent() && axes.isPresent()
        ? Optional.of(new BodyFrame(point.get().body(), point.get().position(), axes.get()))
        : Optional.empty();
  }

  /** Returns an end's {@code vector}, which it must have. */
  public Optional<Vector3> direction(Element element, String meaning) {
    Optional<BodyEnd> end = names.end(element);
    if (end.isPresent() && !end.get().has("vector")) {
      error(MessageCode.MISSING_VECTOR, element, "names no vector, which is " + meaning);
    }
    return end.flatMap(e -> e.direction("vector"));
  }

  private Optional<Rotation> axes(BodyEnd end) {
    if (!end.has("vector")) {
      if (end.has("vector2")) {
        error(MessageCode.SECOND_VECTOR, end.element(), "names vector2 but no vector");
        return Optional.empty();
      }
      return Optional.of(Rotation.IDENTITY);
    }
    Optional<Vector3> z = end.direction("vector");
    if (z.isEmpty()) {
      return Optional.empty();
    }
    return end.has("vector2") ? withDirection(end, z.get()) : least(end, z.get());
  }

  private Optional<Rotation> withDirection(BodyEnd end, Vector3 z) {
    Optional<Vector3> second = end.direction("vector2");
    if (second.isPresent() && AlignmentRotation.areParallel(z, second.get())) {
      error(MessageCode.SECOND_VECTOR, end.element(), "vector2 is parallel to vector");
      return Optional.empty();
    }
    return second
        .map(direction -> AlignmentRotation.normalTo(z, direction))
        .map(x -> Rotation.ofColumns(x, z.cross(x), z));
  }

  private Optional<Rotation> least(BodyEnd end, Vector3 z) {
    Optional<Rotation> least = AlignmentRotation.least(Z, z);
    if (least.isEmpty()) {
      error(
          MessageCode.OPPOSITE_VECTORS,
          end.element(),
          "vector is opposite to the body's z axis, so the other axes are not defined; add"
              + " vector2");
    }
    return least;
  }

  private void error(MessageCode code, Element element, String message) {
    diagnostics.error(code, element.position(), element.role() + " " + message);
  }
}
