package org.mechservice.robot;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.spatial.Vector3;

/**
 * A surface of triangles, and what its mass properties are by the conventions of MuJoCo.
 *
 * @param points corners, m
 * @param faces corners of each triangle, counted from 0, against the clock seen from outside
 */
record TriangleMesh(List<Vector3> points, List<int[]> faces) {
  /** How the mass of a mesh is spread. */
  enum Spread {
    /** In the volume of closed surfaces, by signed tetrahedra. */
    EXACT,
    /** By tetrahedra about the middle that all count as positive: overlaps count several times. */
    LEGACY,
    /** In the convex hull. */
    CONVEX,
    /** On the surface. */
    SHELL
  }

  TriangleMesh {
    points = List.copyOf(points);
    faces = List.copyOf(faces);
  }

  /** Returns several meshes as one. */
  static TriangleMesh together(List<TriangleMesh> meshes) {
    List<Vector3> points = new ArrayList<>();
    List<int[]> faces = new ArrayList<>();
    for (TriangleMesh mesh : meshes) {
      int from = points.size();
      points.addAll(mesh.points);
      mesh.faces.forEach(f -> faces.add(new int[] {f[0] + from, f[1] + from, f[2] + from}));
    }
    return new TriangleMesh(points, faces);
  }

  /** Returns the mesh with each coordinate times a factor. */
  TriangleMesh scaled(Vector3 by) {
    List<Vector3> moved =
        points.stream()
            .map(p -> new Vector3(p.x() * by.x(), p.y() * by.y(), p.z() * by.z()))
            .toList();
    boolean mirrored = by.x() * by.y() * by.z() < 0;
    return new TriangleMesh(
        moved, mirrored ? faces.stream().map(f -> new int[] {f[0], f[2], f[1]}).toList() : faces);
  }

  /** Returns the mesh in another frame. */
  TriangleMesh in(Robot.Frame frame) {
    return new TriangleMesh(
        points.stream().map(p -> frame.at().plus(frame.turn().apply(p))).toList(), faces);
  }

  /** Returns whether every edge belongs to two triangles that run along it in opposite senses. */
  boolean isClosed() {
    Map<Vector3, Integer> same = new HashMap<>();
    int[] index = new int[points.size()];
    for (int i = 0; i < index.length; i++) {
      index[i] = same.computeIfAbsent(points.get(i), key -> same.size());
    }
    Map<Long, Integer> edges = new HashMap<>();
    for (int[] face : faces) {
      for (int i = 0; i < 3; i++) {
        long from = index[face[i]];
        long to = index[face[(i + 1) % 3]];
        if (from != to) {
          edges.merge(
              Math.min(from, to) << 32 | Math.max(from, to), from < to ? 1 : -1, Integer::sum);
        }
      }
    }
    return edges.values().stream().allMatch(sum -> sum == 0);
  }

  /** Returns its mass properties; the volume is not positive if it has none. */
  UniformShape shape(Spread spread) {
    if (spread == Spread.CONVEX || faces.isEmpty()) {
      return ConvexHull.of(points).shape(Spread.EXACT);
    }
    return spread == Spread.SHELL ? shell() : solid(spread == Spread.LEGACY);
  }

  private Vector3 corner(int[] face, int i) {
    return points.get(face[i]);
  }

  private UniformShape shell() {
    double area = 0;
    Vector3 moment = Vector3.ZERO;
    double[] squares = new double[6];
    for (int[] face : faces) {
      Vector3 a = corner(face, 0);
      Vector3 b = corner(face, 1);
      Vector3 c = corner(face, 2);
      double part = b.minus(a).cross(c.minus(a)).norm() / 2;
      area += part;
      moment = moment.plus(a.plus(b).plus(c).times(part / 3));
      addSquares(squares, part / 12, List.of(a, b, c));
    }
    return of(area, moment, squares);
  }

  /** Integrals over tetrahedra from a middle to each triangle. */
  private UniformShape solid(boolean allPositive) {
    Vector3 middle = middle();
    double volume = 0;
    Vector3 moment = Vector3.ZERO;
    for (int[] face : faces) {
      double part = volume(face, middle, allPositive);
      volume += part;
      Vector3 sum = corner(face, 0).plus(corner(face, 1)).plus(corner(face, 2)).plus(middle);
      moment = moment.plus(sum.times(part / 4));
    }
    if (!(volume > 0)) {
      return new UniformShape(volume, middle, List.of(0.0, 0.0, 0.0, 0.0, 0.0, 0.0));
    }
    Vector3 centre = moment.times(1 / volume);
    // MuJoCo takes the tetrahedra about the centre of mass for the moments, also where overlaps
    // make another volume of them.
    double again = 0;
    double[] squares = new double[6];
    for (int[] face : faces) {
      double part = volume(face, centre, allPositive);
      again += part;
      List<Vector3> corners = new ArrayList<>();
      for (int i = 0; i < 3; i++) {
        corners.add(corner(face, i).minus(centre));
      }
      corners.add(Vector3.ZERO);
      addSquares(squares, part / 20, corners);
    }
    UniformShape about = of(again, Vector3.ZERO, squares);
    return new UniformShape(allPositive ? again : volume, centre, about.moments());
  }

  /** Returns the middle of the surface. */
  private Vector3 middle() {
    double area = 0;
    Vector3 moment = Vector3.ZERO;
    for (int[] face : faces) {
      Vector3 a = corner(face, 0);
      Vector3 b = corner(face, 1);
      Vector3 c = corner(face, 2);
      double part = b.minus(a).cross(c.minus(a)).norm() / 2;
      area += part;
      moment = moment.plus(a.plus(b).plus(c).times(part / 3));
    }
    return area > 0 ? moment.times(1 / area) : Vector3.ZERO;
  }

  private double volume(int[] face, Vector3 from, boolean allPositive) {
    Vector3 a = corner(face, 0).minus(from);
    Vector3 b = corner(face, 1).minus(from);
    Vector3 c = corner(face, 2).minus(from);
    double signed = a.dot(b.cross(c)) / 6;
    return allPositive ? Math.abs(signed) : signed;
  }

  /** Adds w (Σ p pᵀ + (Σ p)(Σ p)ᵀ): xx, yy, zz, xy, xz, yz. */
  private static void addSquares(double[] squares, double w, List<Vector3> corners) {
    List<Vector3> all = new ArrayList<>(corners);
    all.add(corners.stream().reduce(Vector3.ZERO, Vector3::plus));
    for (Vector3 p : all) {
      squares[0] += w * p.x() * p.x();
      squares[1] += w * p.y() * p.y();
      squares[2] += w * p.z() * p.z();
      squares[3] += w * p.x() * p.y();
      squares[4] += w * p.x() * p.z();
      squares[5] += w * p.y() * p.z();
    }
  }

  /** Returns the shape of a size with its first and second moments about the origin. */
  private static UniformShape of(double size, Vector3 moment, double[] squares) {
    Vector3 c = moment.times(1 / size);
    double xx = squares[0] / size - c.x() * c.x();
    double yy = squares[1] / size - c.y() * c.y();
    double zz = squares[2] / size - c.z() * c.z();
    return new UniformShape(
        size,
        c,
        List.of(
            yy + zz,
            xx + zz,
            xx + yy,
            -(squares[3] / size - c.x() * c.y()),
            -(squares[4] / size - c.x() * c.z()),
            -(squares[5] / size - c.y() * c.z())));
  }
}
