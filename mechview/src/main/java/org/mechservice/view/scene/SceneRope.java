package org.mechservice.view.scene;

import java.util.List;

/**
 * A rope, a cable or a muscle of a picture.
 *
 * @param name name in the model file
 * @param muscle whether it is a muscle
 * @param stops what it passes: an eye at both ends and on both sides of a branch
 * @param plane the frame whose z axis is normal to its pulleys; of no meaning without pulleys
 */
public record SceneRope(String name, boolean muscle, List<Stop> stops, Frame plane) {
  public SceneRope {
    stops = List.copyOf(stops);
  }

  /** Returns a rope from point to point. */
  public static SceneRope straight(String name, List<Anchor> points) {
    List<Stop> eyes = points.stream().<Stop>map(Eye::new).toList();
    return new SceneRope(name, false, eyes, new Frame(Anchor.ROOT, BodyPose.WORLD));
  }

  /**
   * Axes fixed in a body.
   *
   * @param body index of the body, or the root's
   * @param axes from them to body axes, with their origin in body axes, m
   */
  public record Frame(int body, BodyPose axes) {}

  /** What a rope passes. */
  public sealed interface Stop {}

  /** A point that it runs through. */
  public record Eye(Anchor at) implements Stop {}

  /**
   * A pulley.
   *
   * @param centre its centre
   * @param radius m
   * @param left whether it lies to the left of the rope, seen against the normal of the plane
   * @param held whether the rope cannot leave it
   */
  public record Pulley(Anchor centre, double radius, boolean left, boolean held) implements Stop {}

  /**
   * A sphere or a cylinder.
   *
   * @param centre of the sphere, or a point of the axis
   * @param axis unit vector of the cylinder in body axes; zero for a sphere
   * @param radius m
   * @param sides a point on whose side it passes, or none
   * @param inside whether it runs through the shape as through a ring
   */
  public record Around(
      Anchor centre, Point3 axis, double radius, List<Anchor> sides, boolean inside)
      implements Stop {
    public Around {
      sides = List.copyOf(sides);
    }
  }

  /** The rope ends at the eye before it and begins anew at the eye behind it. */
  public record Branch() implements Stop {}
}
