package org.mechservice.solver.distance;

/**
 * A convex shape: all points within a distance, its margin, of a convex core. Lengths in m, in the
 * shape's own axes.
 */
public interface ConvexShape {
  /**
   * Writes a point of the core that is farthest in a direction.
   *
   * @param x of the direction, which need not have unit length and may be zero
   * @param y likewise
   * @param z likewise
   * @param point 3 numbers; overwritten
   */
  void support(double x, double y, double z, double[] point);

  /** Returns the margin, m: 0 if the shape is its core. */
  double margin();
}
