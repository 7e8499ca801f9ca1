package org.mechservice.solver.spatial;

/**
 * A vector in three dimensions; its user states frame and unit.
 *
 * @param x first component
 * @param y second component
 * @param z third component
 */
public record Vector3(double x, double y, double z) {
  public static final Vector3 ZERO = new Vector3(0, 0, 0);

  /** Returns this + other. */
  public Vector3 plus(Vector3 other) {
    return new Vector3(x + other.x, y + other.y, z + other.z);
  }

  /** Returns this − other. */
  public Vector3 minus(Vector3 other) {
    return new Vector3(x - other.x, y - other.y, z - other.z);
  }

  /** Returns factor · this. */
  public Vector3 times(double factor) {
    return new Vector3(factor * x, factor * y, factor * z);
  }

  /** Returns −this, without negative zeros. */
  public Vector3 negated() {
    return new Vector3(0 - x, 0 - y, 0 - z);
  }

  /** Returns the scalar product. */
  public double dot(Vector3 other) {
    return x * other.x + y * other.y + z * other.z;
  }

  /** Returns this × other. */
  public Vector3 cross(Vector3 other) {
    return new Vector3(
        y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
  }

  /** Returns the Euclidean length, safe from overflow and underflow. */
  public double norm() {
    double scale = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    if (scale == 0 || Double.isInfinite(scale)) {
      return scale;
    }
    double sx = x / scale;
    double sy = y / scale;
    double sz = z / scale;
    return scale * Math.sqrt(sx * sx + sy * sy + sz * sz);
  }

  /**
   * Returns the unit vector of the same direction. A vector along a coordinate axis gives that axis
   * exactly.
   *
   * @throws ArithmeticException if the length is zero or not finite
   */
  public Vector3 normalized() {
    double norm = norm();
    if (!(norm > 0) || Double.isInfinite(norm)) {
      throw new ArithmeticException("a vector of length " + norm + " has no direction");
    }
    return new Vector3(x / norm, y / norm, z / norm);
  }
}
