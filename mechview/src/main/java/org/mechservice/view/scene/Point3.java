package org.mechservice.view.scene;

/**
 * A point or a direction in space.
 *
 * @param x first coordinate, m (1 for directions)
 * @param y second coordinate
 * @param z third coordinate
 */
public record Point3(double x, double y, double z) {
  /** The origin. */
  public static final Point3 ZERO = new Point3(0, 0, 0);

  /** Returns this + other. */
  public Point3 plus(Point3 other) {
    return new Point3(x + other.x, y + other.y, z + other.z);
  }

  /** Returns this − other. */
  public Point3 minus(Point3 other) {
    return new Point3(x - other.x, y - other.y, z - other.z);
  }

  /** Returns factor · this. */
  public Point3 times(double factor) {
    return new Point3(factor * x, factor * y, factor * z);
  }

  /** Returns the scalar product. */
  public double dot(Point3 other) {
    return x * other.x + y * other.y + z * other.z;
  }

  /** Returns the vector product this × other. */
  public Point3 cross(Point3 other) {
    return new Point3(
        y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
  }

  /** Returns the length. */
  public double norm() {
    return Math.sqrt(dot(this));
  }
}
