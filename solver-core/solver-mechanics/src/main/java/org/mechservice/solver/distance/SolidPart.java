package org.mechservice.solver.distance;

import java.util.ArrayList;
import java.util.List;

/**
 * A convex part of a body's solids, in body axes, m: its shape, and the corners of a polytope
 * within it. A round part is exact as a shape; its corners miss it by at most a band.
 */
public final class SolidPart {
  private static final int FEWEST_SIDES = 8;
  private static final int MOST_SIDES = 512;

  private final ConvexShape shape;
  private final double[] corners;
  private final double margin;
  private final double band;
  private final double shapeBand;
  private final double[] centre = new double[3];
  private final double radius;

  private SolidPart(
      ConvexShape shape, double[] corners, double margin, double band, double shapeBand) {
    this.shapeBand = shapeBand;
    this.shape = shape;
    this.corners = corners;
    this.margin = margin;
    this.band = band;
    int count = corners.length / 3;
    for (int i = 0; i < corners.length; i++) {
      centre[i % 3] += corners[i] / count;
    }
    double square = 0;
    for (int i = 0; i < corners.length; i += 3) {
      double x = corners[i] - centre[0];
      double y = corners[i + 1] - centre[1];
      double z = corners[i + 2] - centre[2];
      square = Math.max(square, x * x + y * y + z * z);
    }
    radius = Math.sqrt(square) + margin + band;
  }

  /** Returns the hull of points, such as a triangle of a surface. */
  public static SolidPart hull(double... points) {
    return new SolidPart(new PointHull(points, 0), points.clone(), 0, 0, 0);
  }

  /** Returns a ball. */
  public static SolidPart ball(double[] centre, double radius) {
    return new SolidPart(new PointHull(centre, radius), centre.clone(), radius, 0, 0);
  }

  /** Returns a box with its edges along the axes. */
  public static SolidPart box(double[] centre, double[] edges) {
    double[] points = new double[24];
    for (int i = 0; i < points.length; i++) {
      int axis = i % 3;
      int side = ((i / 3) >> axis) & 1;
      points[i] = centre[axis] + (side - 0.5) * edges[axis];
    }
    return hull(points);
  }

  /**
   * Returns a cylinder, a frustum of a cone or a cone.
   *
   * @param band most by which the corners may miss the round surface, m; more if that took more
   *     than 512 sides
   */
  public static SolidPart frustum(
      double[] from, double[] to, double bottom, double top, double band) {
    double[][] across = across(from, to);
    int sides = sides(Math.max(bottom, top), band);
    double[] points = new double[6 * sides];
    for (int i = 0; i < sides; i++) {
      double turn = 2 * Math.PI * i / sides;
      onCircle(from, bottom, turn, across, points, 6 * i);
      onCircle(to, top, turn, across, points, 6 * i + 3);
    }
    double missed = Math.max(bottom, top) * (1 - StrictMath.cos(Math.PI / sides));
    return new SolidPart(new Frustum(from, to, bottom, top), points, 0, missed, 0);
  }

  /**
   * Returns the parts of a tube: wedges between its two surfaces, whose corners lie on both.
   *
   * @param band most by which a wedge may miss either surface, m, as for {@link #frustum}
   */
  public static List<SolidPart> tube(
      double[] from, double[] to, double bottom, double top, double inner, double band) {
    double[][] across = across(from, to);
    double outer = Math.max(bottom, top);
    int sides = sides(outer, band);
    double missed = outer * (1 - StrictMath.cos(Math.PI / sides));
    List<SolidPart> wedges = new ArrayList<>();
    for (int i = 0; i < sides; i++) {
      double[] points = new double[24];
      for (int side = 0; side < 2; side++) {
        double turn = 2 * Math.PI * (i + side) / sides;
        onCircle(from, inner, turn, across, points, 12 * side);
        onCircle(from, bottom, turn, across, points, 12 * side + 3);
        onCircle(to, inner, turn, across, points, 12 * side + 6);
        onCircle(to, top, turn, across, points, 12 * side + 9);
      }
      wedges.add(new SolidPart(new PointHull(points, 0), points, 0, missed, missed));
    }
    return wedges;
  }

  /** Sagitta of n sides: r (1 − cos(π/n)) ≤ r π² / (2 n²). */
  private static int sides(double radius, double band) {
    double least = Math.PI * Math.sqrt(radius / (2 * band));
    return (int) Math.max(FEWEST_SIDES, Math.min(MOST_SIDES, Math.ceil(least)));
  }

  /** Returns two unit vectors across an axis. */
  private static double[][] across(double[] from, double[] to) {
    double[] u = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    int least = 0;
    for (int i = 1; i < 3; i++) {
      least = Math.abs(u[i]) < Math.abs(u[least]) ? i : least;
    }
    double[] other = new double[3];
    other[least] = 1;
    double[] first = unit(cross(u, other));
    return new double[][] {first, unit(cross(u, first))};
  }

  private static double[] cross(double[] p, double[] q) {
    return new double[] {
      p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]
    };
  }

  private static double[] unit(double[] v) {
    double length = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return new double[] {v[0] / length, v[1] / length, v[2] / length};
  }

  private static void onCircle(
      double[] centre, double radius, double turn, double[][] across, double[] points, int at) {
    double cosine = radius * StrictMath.cos(turn);
    double sine = radius * StrictMath.sin(turn);
    for (int i = 0; i < 3; i++) {
      points[at + i] = centre[i] + cosine * across[0][i] + sine * across[1][i];
    }
  }

  /** Returns the shape itself. */
  ConvexShape shape() {
    return shape;
  }

  /** Returns the corners of the polytope, to which {@link #margin} is added. */
  double[] corners() {
    return corners;
  }

  double margin() {
    return margin;
  }

  /** Returns by how much the polytope may miss the shape, m. */
  public double band() {
    return band;
  }

  /** Returns by how much the shape itself may miss the solid, m: only that of a wedge of a tube. */
  double shapeBand() {
    return shapeBand;
  }

  /** Returns the centre of a ball around the part. */
  double[] centre() {
    return centre;
  }

  /** Returns the radius of that ball. */
  double radius() {
    return radius;
  }
}
