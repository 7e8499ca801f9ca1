package org.mechservice.solver.distance;

import java.util.Arrays;

/**
 * The convex hull of points, rounded by a margin: a box, a wedge, a triangle; with a single point
 * and a margin a ball, with two a capsule.
 */
public final class PointHull implements ConvexShape {
  private final double[] points;
  private final double margin;

  /**
   * Makes a hull.
   *
   * @param points x, y, z of each, m; copied
   * @param margin m
   * @throws IllegalArgumentException if there is no point, or a number is not finite
   */
  public PointHull(double[] points, double margin) {
    this(points.clone(), margin, true);
    boolean finite = Arrays.stream(points).allMatch(Double::isFinite);
    if (points.length < 3 || points.length % 3 != 0 || !finite || !(margin >= 0)) {
      throw new IllegalArgumentException("a hull has finite points, three numbers each");
    }
  }

  private PointHull(double[] points, double margin, boolean shared) {
    this.points = points;
    this.margin = shared ? margin : 0;
  }

  /** Returns a hull of points that the caller goes on to write; without a margin. */
  static PointHull over(double[] points) {
    return new PointHull(points, 0, false);
  }

  @Override
  public void support(double x, double y, double z, double[] point) {
    int best = 0;
    double most = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < points.length; i += 3) {
      double along = x * points[i] + y * points[i + 1] + z * points[i + 2];
      if (along > most) {
        most = along;
        best = i;
      }
    }
    point[0] = points[best];
    point[1] = points[best + 1];
    point[2] = points[best + 2];
  }

  @Override
  public double margin() {
    return margin;
  }
}
