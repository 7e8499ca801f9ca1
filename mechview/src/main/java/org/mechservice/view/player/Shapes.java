package org.mechservice.view.player;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.view.mesh.Mesh;
import org.mechservice.view.mesh.Solids;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;

/** Makes the shapes of one stage; shapes of one form share their surface. Lengths are in m. */
final class Shapes {
  /** Boxes of so many sizes get edges that are broken; more share one surface with sharp edges. */
  private static final int MOST_BLOCKS = 64;

  private static final Mesh BALL = Solids.sphere(1);
  private static final Mesh CYLINDER = Solids.cylinder(1, 1);
  private static final Mesh BLOCK = Solids.box(1, 1, 1);

  private final Map<Object, Mesh> surfaces = new HashMap<>();
  private int blocks;

  /** A round surface by its proportions. */
  private record Round(String form, double first, double second) {}

  /** Returns a sphere. */
  Shape ball(Point3 centre, double radius) {
    return new Shape(BALL, at(centre), new Point3(radius, radius, radius));
  }

  /** Returns a closed cylinder about the z axis of a pose, which is in its middle. */
  Shape cylinder(BodyPose at, double radius, double height) {
    return new Shape(CYLINDER, at, new Point3(radius, radius, height));
  }

  /** Returns a cylinder between two points; none if they coincide. */
  List<Shape> rod(Point3 from, Point3 to, double radius) {
    Point3 along = to.minus(from);
    double length = along.norm();
    return length > 0 ? List.of(cylinder(between(from, to), radius, length)) : List.of();
  }

  /** Returns a cylinder between two points with half balls at its ends. */
  List<Shape> capsule(Point3 from, Point3 to, double radius) {
    return from.equals(to)
        ? List.of(ball(from, radius))
        : List.of(rod(from, to, radius).get(0), ball(from, radius), ball(to, radius));
  }

  /** Returns a box about a pose, edges along its axes. */
  Shape block(BodyPose at, Point3 edges) {
    Mesh known = surfaces.get(edges);
    if (known == null && blocks < MOST_BLOCKS) {
      blocks++;
      known = Solids.block(edges);
      surfaces.put(edges, known);
    }
    return known == null ? new Shape(BLOCK, at, edges) : Shape.of(known, at);
  }

  /** Returns a closed tube about the z axis of a pose, which is in its middle. */
  Shape tube(BodyPose at, double inner, double outer, double height) {
    return scaled("tube", at, outer, inner / outer, height / outer);
  }

  /** Returns a closed frustum of a cone about the z axis of a pose, which is in its middle. */
  Shape frustum(BodyPose at, double radius, double top, double height) {
    return radius >= top
        ? scaled("frustum", at, radius, top / radius, height / radius)
        : Shape.of(Solids.frustum(radius, top, height), at);
  }

  /** Returns the rubber of a tyre about the z axis of a pose. */
  Shape tyre(BodyPose at, double radius, double width) {
    return scaled("tyre", at, radius, width / radius, 0);
  }

  /** Returns a gear wheel about the z axis of a pose: its pitch radius, its width. */
  Shape gear(BodyPose at, double radius, double width, int teeth) {
    return scaled("gear", at, radius, width / radius, teeth);
  }

  /** Returns a ring with teeth inside about the z axis of a pose. */
  Shape ring(BodyPose at, double radius, double width, int teeth) {
    return scaled("ring", at, radius, width / radius, teeth);
  }

  /** Returns a wheel with a groove for a rope or belt about the z axis of a pose. */
  Shape pulley(BodyPose at, double radius, double width) {
    return scaled("pulley", at, radius, width / radius, 0);
  }

  private Shape scaled(String form, BodyPose at, double radius, double first, double second) {
    Round proportions = new Round(form, round(first), round(second));
    Mesh surface =
        surfaces.computeIfAbsent(
            proportions,
            key ->
                switch (form) {
                  case "tube" -> Solids.tube(first, 1, second);
                  case "frustum" -> Solids.frustum(1, first, second);
                  case "tyre" -> Solids.tyre(1, first);
                  case "gear" -> Solids.gear(1, first, (int) second);
                  case "ring" -> Solids.ring(1, first, (int) second);
                  default -> Solids.pulley(1, first);
                });
    return new Shape(surface, at, new Point3(radius, radius, radius));
  }

  /** Makes proportions that differ by rounding alone equal. */
  private static double round(double proportion) {
    return (float) proportion;
  }

  static BodyPose at(Point3 point) {
    return new BodyPose(point, 1, 0, 0, 0);
  }

  private static BodyPose between(Point3 from, Point3 to) {
    Point3 along = to.minus(from);
    return Solids.zAlong(along.times(1 / along.norm()), from.plus(to).times(0.5));
  }
}
