package org.mechservice.mechml;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.spatial.Vector3;

/**
 * What a rope, a cable or a muscle passes, for pictures. Its length is a formula of the mechanism.
 *
 * @param stops from its first end to its last; an eye at both ends and on both sides of a branch
 * @param plane whose z axis is normal to its pulleys; empty without pulleys
 * @param muscle whether it is a muscle
 */
public record Route(List<Stop> stops, Optional<BodyFrame> plane, boolean muscle) {
  public Route {
    stops = List.copyOf(stops);
  }

  /** What a rope passes. */
  public sealed interface Stop {}

  /** A point that it runs through. */
  public record Eye(BodyPoint at) implements Stop {}

  /**
   * A pulley in the plane of the rope.
   *
   * @param centre its centre
   * @param radius of parameters, m
   * @param left whether it lies to the left of the rope, seen against the normal of the plane
   * @param held whether the rope cannot leave it, since it has whole turns there
   */
  public record Pulley(BodyPoint centre, Expression radius, boolean left, boolean held)
      implements Stop {}

  /**
   * A sphere or a cylinder without ends that it goes around.
   *
   * @param centre of the sphere, or a point of the axis
   * @param axis unit vector of the cylinder in body axes; empty for a sphere
   * @param radius of parameters, m
   * @param side a point on whose side it passes
   * @param inside whether it runs through the shape as through a ring
   */
  public record Around(
      BodyPoint centre,
      Optional<Vector3> axis,
      Expression radius,
      Optional<BodyPoint> side,
      boolean inside)
      implements Stop {}

  /** The rope ends at the eye before it and begins anew at the eye behind it. */
  public record Branch() implements Stop {}
}
