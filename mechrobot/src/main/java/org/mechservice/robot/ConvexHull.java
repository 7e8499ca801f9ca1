package org.mechservice.robot;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.mechservice.solver.spatial.Vector3;

/**
 * The convex hull of points by the incremental algorithm: each point outside takes away the faces
 * that it sees and joins the rim of the hole. Source: O'Rourke, Computational Geometry in C, 1998,
 * chapter 4.
 */
final class ConvexHull {
  /** Distance from a face below which a point counts as on it, relative to the extent. */
  private static final double ON_FACE = 1e-12;

  private ConvexHull() {}

  /** Returns the hull; without faces if all points lie in a plane. */
  static TriangleMesh of(List<Vector3> given) {
    List<Vector3> points = new ArrayList<>(new LinkedHashSet<>(given));
    int[] first = tetrahedron(points);
    List<int[]> faces = new ArrayList<>();
    if (first.length < 4) {
      return new TriangleMesh(points, List.of());
    }
    Vector3 inside =
        points
            .get(first[0])
            .plus(points.get(first[1]))
            .plus(points.get(first[2]))
            .plus(points.get(first[3]))
            .times(0.25);
    int[][] corners = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
    for (int[] c : corners) {
      int[] face = {first[c[0]], first[c[1]], first[c[2]]};
      faces.add(height(points, face, inside) > 0 ? new int[] {face[0], face[2], face[1]} : face);
    }
    double extent = 0;
    for (Vector3 p : points) {
      extent = Math.max(extent, p.minus(inside).norm());
    }
    for (int i = 0; i < points.size(); i++) {
      add(points, faces, i, ON_FACE * extent);
    }
    return new TriangleMesh(points, faces);
  }

  private static void add(List<Vector3> points, List<int[]> faces, int point, double least) {
    List<int[]> seen =
        faces.stream().filter(face -> height(points, face, points.get(point)) > least).toList();
    if (seen.isEmpty()) {
      return;
    }
    Map<Long, int[]> rim = new HashMap<>();
    for (int[] face : seen) {
      for (int i = 0; i < 3; i++) {
        int from = face[i];
        int to = face[(i + 1) % 3];
        if (rim.remove((long) to << 32 | from) == null) {
          rim.put((long) from << 32 | to, new int[] {from, to, point});
        }
      }
    }
    faces.removeAll(seen);
    rim.entrySet().stream()
        .sorted(Map.Entry.comparingByKey())
        .forEach(edge -> faces.add(edge.getValue()));
  }

  /** Returns how far a point is outside of a face's plane. */
  private static double height(List<Vector3> points, int[] face, Vector3 p) {
    Vector3 a = points.get(face[0]);
    Vector3 n = points.get(face[1]).minus(a).cross(points.get(face[2]).minus(a));
    double norm = n.norm();
    return norm > 0 ? n.dot(p.minus(a)) / norm : 0;
  }

  /** Returns four points that are in no plane; fewer if there are none. */
  private static int[] tetrahedron(List<Vector3> points) {
    if (points.isEmpty()) {
      return new int[0];
    }
    int b = farthest(points, 0, p -> p.minus(points.get(0)).norm());
    Vector3 along = points.get(b).minus(points.get(0));
    int c = farthest(points, 0, p -> p.minus(points.get(0)).cross(along).norm());
    Vector3 normal = along.cross(points.get(c).minus(points.get(0)));
    int d = farthest(points, 0, p -> Math.abs(p.minus(points.get(0)).dot(normal)));
    double size = along.norm();
    double flat = Math.abs(points.get(d).minus(points.get(0)).dot(normal));
    return flat > ON_FACE * size * size * size ? new int[] {0, b, c, d} : new int[0];
  }

  private static int farthest(List<Vector3> points, int start, ToDoubleFunction<Vector3> distance) {
    int best = start;
    for (int i = 0; i < points.size(); i++) {
      if (distance.applyAsDouble(points.get(i)) > distance.applyAsDouble(points.get(best))) {
        best = i;
      }
    }
    return best;
  }
}
