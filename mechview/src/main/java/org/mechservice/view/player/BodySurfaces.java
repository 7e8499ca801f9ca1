package org.mechservice.view.player;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.view.mesh.Mesh;
import org.mechservice.view.mesh.MeshException;
import org.mechservice.view.mesh.MeshFolder;
import org.mechservice.view.mesh.Solids;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneSolid;

/**
 * The solids of a body as surfaces. Each is drawn where and as large as the model has it, but not
 * thinner than can be seen.
 */
final class BodySurfaces {
  /** Least radius, and half of the least edge, that is drawn, in parts of the extent. */
  private static final double THINNEST = 0.003;

  private final MeshFolder folder;
  private final Shapes shapes;
  private final double extent;

  BodySurfaces(MeshFolder folder, Shapes shapes, double extent) {
    this.folder = folder;
    this.shapes = shapes;
    this.extent = extent;
  }

  /**
   * Returns the shapes of a solid, in body axes, m.
   *
   * @throws MeshException if its file cannot be shown
   */
  List<Shape> of(SceneSolid solid) throws MeshException {
    double least = THINNEST * extent;
    if (solid instanceof SceneSolid.Block block) {
      Point3 edges = block.edges();
      return List.of(
          shapes.block(
              Shapes.at(block.center()),
              new Point3(
                  Math.max(2 * least, edges.x()),
                  Math.max(2 * least, edges.y()),
                  Math.max(2 * least, edges.z()))));
    } else if (solid instanceof SceneSolid.Ball ball) {
      return List.of(shapes.ball(ball.center(), Math.max(least, ball.radius())));
    } else if (solid instanceof SceneSolid.Surface surface) {
      double s = surface.scale();
      List<Shape> read = new ArrayList<>();
      for (Mesh mesh : folder.read(surface.file())) {
        read.add(new Shape(mesh, Shapes.at(surface.origin()), new Point3(s, s, s)));
      }
      return read;
    }
    SceneSolid.Round round = (SceneSolid.Round) solid;
    Point3 along = round.to().minus(round.from());
    double length = along.norm();
    double radius = Math.max(least, round.radius());
    boolean straight = round.radius() == round.top();
    BodyPose middle = Solids.zAlong(along.times(1 / length), round.from().plus(along.times(0.5)));
    if (straight) {
      return List.of(
          round.inner() > 0
              ? shapes.tube(middle, round.inner(), radius, length)
              : shapes.cylinder(middle, radius, length));
    }
    return List.of(shapes.frustum(middle, radius, round.top(), length));
  }

  /**
   * Returns how far a point is from a solid, m: 0 within it. Surfaces from files count as if they
   * were everywhere, and a frustum as the cylinder around it.
   */
  static double distance(SceneSolid solid, Point3 point) {
    if (solid instanceof SceneSolid.Block block) {
      Point3 from = point.minus(block.center());
      Point3 edges = block.edges();
      return new Point3(
              beyond(from.x(), edges.x() / 2),
              beyond(from.y(), edges.y() / 2),
              beyond(from.z(), edges.z() / 2))
          .norm();
    } else if (solid instanceof SceneSolid.Ball ball) {
      return beyond(point.minus(ball.center()).norm(), ball.radius());
    } else if (solid instanceof SceneSolid.Round round) {
      Point3 along = round.to().minus(round.from());
      double length = along.norm();
      Point3 from = point.minus(round.from());
      double height = from.dot(along) / length;
      double aside = from.minus(along.times(height / length)).norm();
      return Math.hypot(
          beyond(height - length / 2, length / 2),
          beyond(aside, Math.max(round.radius(), round.top())));
    }
    return 0;
  }

  /** Returns the middle of a solid; of a surface from a file, its origin. */
  static Point3 centre(SceneSolid solid) {
    if (solid instanceof SceneSolid.Block block) {
      return block.center();
    } else if (solid instanceof SceneSolid.Ball ball) {
      return ball.center();
    } else if (solid instanceof SceneSolid.Round round) {
      return round.from().plus(round.to()).times(0.5);
    }
    return ((SceneSolid.Surface) solid).origin();
  }

  /** Returns the largest measure of a solid, m; 0 of a surface from a file. */
  static double size(SceneSolid solid) {
    if (solid instanceof SceneSolid.Block block) {
      return block.edges().norm();
    } else if (solid instanceof SceneSolid.Ball ball) {
      return 2 * ball.radius();
    } else if (solid instanceof SceneSolid.Round round) {
      return Math.hypot(
          round.to().minus(round.from()).norm(), 2 * Math.max(round.radius(), round.top()));
    }
    return 0;
  }

  /** Returns by how much a number is beyond a bound in either direction. */
  private static double beyond(double value, double bound) {
    return Math.max(0, Math.abs(value) - bound);
  }
}
