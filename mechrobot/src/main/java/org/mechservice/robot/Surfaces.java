package org.mechservice.robot;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.spatial.Vector3;

/**
 * Surfaces of simple shapes as triangles, for pictures. Their axes and centres are those of URDF.
 */
final class Surfaces {
  /** Parts of a circle: 15° each look round. */
  private static final int PARTS = 24;

  private Surfaces() {}

  /** Returns a box with its edges along x, y and z, m. */
  static TriangleMesh box(Vector3 edges) {
    List<Vector3> corners = new ArrayList<>();
    for (int i = 0; i < 8; i++) {
      corners.add(
          new Vector3(
              edges.x() * ((i & 1) - 0.5),
              edges.y() * ((i >> 1 & 1) - 0.5),
              edges.z() * ((i >> 2) - 0.5)));
    }
    int[][] sides = {
      {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}
    };
    List<int[]> faces = new ArrayList<>();
    for (int[] s : sides) {
      faces.add(new int[] {s[0], s[1], s[2]});
      faces.add(new int[] {s[0], s[2], s[3]});
    }
    return new TriangleMesh(corners, faces);
  }

  /** Returns an ellipsoid with its semi-axes along x, y and z, m. */
  static TriangleMesh ellipsoid(Vector3 axes) {
    return capsule(1, 0).scaled(axes);
  }

  /** Returns a cylinder along z, m. */
  static TriangleMesh cylinder(double radius, double length) {
    double h = length / 2;
    return turned(
        List.of(
            new double[] {0, -h},
            new double[] {radius, -h},
            new double[] {radius, h},
            new double[] {0, h}));
  }

  /** Returns a cone along z, pointed above, whose frame is in the middle of its height, m. */
  static TriangleMesh cone(double radius, double length) {
    double h = length / 2;
    return turned(List.of(new double[] {0, -h}, new double[] {radius, -h}, new double[] {0, h}));
  }

  /**
   * Returns a cylinder along z with two half spheres, m.
   *
   * @param length of the cylinder
   */
  static TriangleMesh capsule(double radius, double length) {
    List<double[]> outline = new ArrayList<>();
    for (int i = 0; i <= PARTS / 2; i++) {
      double angle = Math.PI * (2.0 * i / PARTS - 0.5);
      double lift = i <= PARTS / 4 ? -length / 2 : length / 2;
      if (i == PARTS / 4 && length > 0) {
        outline.add(new double[] {radius, -length / 2});
        lift = length / 2;
      }
      outline.add(new double[] {radius * Math.cos(angle), radius * Math.sin(angle) + lift});
    }
    return turned(outline);
  }

  /** Returns the surface that an outline of radii and heights sweeps about z, from below up. */
  private static TriangleMesh turned(List<double[]> outline) {
    List<Vector3> points = new ArrayList<>();
    for (double[] ring : outline) {
      for (int k = 0; k < PARTS; k++) {
        double angle = 2 * Math.PI * k / PARTS;
        points.add(new Vector3(ring[0] * Math.cos(angle), ring[0] * Math.sin(angle), ring[1]));
      }
    }
    List<int[]> faces = new ArrayList<>();
    for (int i = 0; i + 1 < outline.size(); i++) {
      for (int k = 0; k < PARTS; k++) {
        int a = PARTS * i + k;
        int b = PARTS * i + (k + 1) % PARTS;
        faces.add(new int[] {a, b, b + PARTS});
        faces.add(new int[] {a, b + PARTS, a + PARTS});
      }
    }
    return new TriangleMesh(points, faces);
  }
}
