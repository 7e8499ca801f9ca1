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
  private final double extent;

  BodySurfaces(MeshFolder folder, double extent) {
    this.folder = folder;
    this.extent = extent;
  }

  /**
   * Returns the surfaces of a solid, in body axes, m.
   *
   * @throws MeshException if its file cannot be shown
   */
  List<Mesh> of(SceneSolid solid) throws MeshException {
    double least = THINNEST * extent;
    if (solid instanceof SceneSolid.Block block) {
      Point3 edges = block.edges();
      Mesh mesh =
          Solids.box(
              Math.max(2 * least, edges.x()),
              Math.max(2 * least, edges.y()),
              Math.max(2 * least, edges.z()));
      return List.of(mesh.moved(at(block.center())));
    } else if (solid instanceof SceneSolid.Ball ball) {
      return List.of(Solids.sphere(Math.max(least, ball.radius())).moved(at(ball.center())));
    } else if (solid instanceof SceneSolid.Surface surface) {
      List<Mesh> meshes = new ArrayList<>();
      for (Mesh mesh : folder.read(surface.file())) {
        meshes.add(mesh.scaled(surface.scale()).moved(at(surface.origin())));
      }
      return meshes;
    }
    SceneSolid.Round round = (SceneSolid.Round) solid;
    Point3 along = round.to().minus(round.from());
    double length = along.norm();
    double radius = Math.max(least, round.radius());
    boolean straight = round.radius() == round.top();
    Mesh mesh =
        straight && round.inner() > 0
            ? Solids.tube(round.inner(), radius, length)
            : Solids.frustum(radius, straight ? radius : round.top(), length);
    Point3 middle = round.from().plus(along.times(0.5));
    return List.of(mesh.moved(Solids.zAlong(along.times(1 / length), middle)));
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

  /** Returns by how much a number is beyond a bound in either direction. */
  private static double beyond(double value, double bound) {
    return Math.max(0, Math.abs(value) - bound);
  }

  private static BodyPose at(Point3 point) {
    return new BodyPose(point, 1, 0, 0, 0);
  }
}
