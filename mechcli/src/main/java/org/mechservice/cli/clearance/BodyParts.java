package org.mechservice.cli.clearance;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.mechservice.mechml.Look;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.Solid;
import org.mechservice.solver.distance.SolidPart;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.view.mesh.Mesh;
import org.mechservice.view.mesh.MeshException;
import org.mechservice.view.mesh.MeshFolder;

/**
 * The shapes of a model's bodies as convex parts: their solids, or what a body without solids looks
 * like. A surface from a file is its triangles.
 */
final class BodyParts {
  private final MechmlModel model;
  private final MeshFolder meshes;
  private final double band;

  /**
   * @param folder of the model's file, for surfaces
   * @param band most by which facets may miss round shapes, m
   */
  BodyParts(MechmlModel model, Path folder, double band) {
    this.model = model;
    meshes = new MeshFolder(folder);
    this.band = band;
  }

  /** Returns whether a body has a shape. */
  boolean has(String body) {
    return !model.solids(body).isEmpty()
        || model.looks(body).stream().anyMatch(look -> !look.solids().isEmpty());
  }

  /**
   * Returns the parts of a body, in its axes, m.
   *
   * @throws MeshException if a surface cannot be read
   */
  List<SolidPart> of(String body) throws MeshException {
    List<SolidPart> parts = new ArrayList<>();
    Placement own = new Placement(Rotation.IDENTITY, Vector3.ZERO);
    for (Solid solid : model.solids(body)) {
      add(solid, own, parts);
    }
    if (parts.isEmpty()) {
      for (Look look : model.looks(body)) {
        Placement placed = new Placement(Rotation.about(look.axis(), look.angle()), look.origin());
        for (Solid solid : look.solids()) {
          add(solid, placed, parts);
        }
      }
    }
    return parts;
  }

  /** Where the axes of shapes are in those of the body. */
  private record Placement(Rotation turn, Vector3 origin) {
    double[] of(double x, double y, double z) {
      Vector3 placed = turn.apply(new Vector3(x, y, z)).plus(origin);
      return new double[] {placed.x(), placed.y(), placed.z()};
    }

    double[] of(Vector3 point) {
      return of(point.x(), point.y(), point.z());
    }
  }

  private void add(Solid solid, Placement placed, List<SolidPart> parts) throws MeshException {
    if (solid instanceof Solid.Block block) {
      parts.add(box(block, placed));
    } else if (solid instanceof Solid.Ball ball) {
      parts.add(SolidPart.ball(placed.of(ball.center()), ball.radius()));
    } else if (solid instanceof Solid.Round round) {
      double[] from = placed.of(round.from());
      double[] to = placed.of(round.to());
      if (round.inner() > 0) {
        parts.addAll(SolidPart.tube(from, to, round.radius(), round.top(), round.inner(), band));
      } else {
        parts.add(SolidPart.frustum(from, to, round.radius(), round.top(), band));
      }
    } else if (solid instanceof Solid.Surface surface) {
      for (Mesh mesh : meshes.read(surface.file())) {
        addTriangles(mesh, surface, placed, parts);
      }
    }
  }

  private static SolidPart box(Solid.Block block, Placement placed) {
    double[] corners = new double[24];
    for (int i = 0; i < 8; i++) {
      double[] corner =
          placed.of(
              block.center().x() + ((i & 1) - 0.5) * block.edges().x(),
              block.center().y() + (((i >> 1) & 1) - 0.5) * block.edges().y(),
              block.center().z() + (((i >> 2) & 1) - 0.5) * block.edges().z());
      System.arraycopy(corner, 0, corners, 3 * i, 3);
    }
    return SolidPart.hull(corners);
  }

  private static void addTriangles(
      Mesh mesh, Solid.Surface surface, Placement placed, List<SolidPart> parts) {
    float[] points = mesh.corners();
    int[] triangles = mesh.triangles();
    for (int t = 0; t < triangles.length; t += 3) {
      double[] corners = new double[9];
      for (int c = 0; c < 3; c++) {
        int at = 3 * triangles[t + c];
        double[] corner =
            placed.of(
                surface.scale() * points[at] + surface.origin().x(),
                surface.scale() * points[at + 1] + surface.origin().y(),
                surface.scale() * points[at + 2] + surface.origin().z());
        System.arraycopy(corner, 0, corners, 3 * c, 3);
      }
      parts.add(SolidPart.hull(corners));
    }
  }
}
