package org.mechservice.mechml.resolve.body;

import java.util.Optional;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/** Computes the rotation that aligns directions of one body with directions of another. */
public final class AlignmentRotation {
  /** Sine of the angle below which two directions count as parallel. */
  private static final double PARALLEL = 1e-6;

  private AlignmentRotation() {}

  /**
   * Returns the least rotation with R · from = to; empty if the directions are opposite.
   *
   * @param from unit vector
   * @param to unit vector
   */
  public static Optional<Rotation> least(Vector3 from, Vector3 to) {
    try {
      return Optional.of(Rotation.least(from, to));
    } catch (ArithmeticException opposite) {
      return Optional.empty();
    }
  }

  /**
   * Returns the rotation with R · from = to that also aligns the parts of the second directions
   * normal to the first ones; empty if a second direction is parallel to the first. All are unit
   * vectors.
   */
  public static Optional<Rotation> aligned(Vector3 from, Vector3 from2, Vector3 to, Vector3 to2) {
    if (areParallel(from, from2) || areParallel(to, to2)) {
      return Optional.empty();
    }
    if (from.equals(to) && from2.equals(to2)) {
      return Optional.of(Rotation.IDENTITY);
    }
    return Optional.of(frame(to, to2).times(frame(from, from2).transposed()));
  }

  /**
   * Returns the unit vector along the part of a vector normal to an axis; the two must not be
   * parallel.
   */
  public static Vector3 normalTo(Vector3 axis, Vector3 vector) {
    // The second pass removes the rounding error that the first leaves along the axis.
    Vector3 normal = axis.cross(vector.cross(axis)).normalized();
    return axis.cross(normal.cross(axis)).normalized();
  }

  /** Returns whether two unit vectors are orthogonal. */
  public static boolean areOrthogonal(Vector3 a, Vector3 b) {
    return Math.abs(a.dot(b)) < PARALLEL;
  }

  /** Returns whether two unit vectors have the same or opposite directions. */
  public static boolean areParallel(Vector3 a, Vector3 b) {
    return a.cross(b).norm() < PARALLEL;
  }

  private static Rotation frame(Vector3 first, Vector3 second) {
    Vector3 normal = first.cross(second).normalized();
    return Rotation.ofColumns(first, normal.cross(first), normal);
  }
}
