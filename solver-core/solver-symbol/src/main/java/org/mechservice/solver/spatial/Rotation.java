package org.mechservice.solver.spatial;

/**
 * A rotation matrix, row by row: it transforms components in the rotated ("child") axes to
 * components in the fixed ("parent") axes.
 */
public record Rotation(
    double xx,
    double xy,
    double xz,
    double yx,
    double yy,
    double yz,
    double zx,
    double zy,
    double zz) {
  public static final Rotation IDENTITY = new Rotation(1, 0, 0, 0, 1, 0, 0, 0, 1);

  /**
   * Cosine below which two unit vectors count as opposite: the least rotation between them is then
   * not defined.
   */
  private static final double OPPOSITE = -1 + 1e-12;

  /** Returns whether this is the identity; faster than equality of records at the first call. */
  public boolean isIdentity() {
    return xx == 1 && yy == 1 && zz == 1;
  }

  /**
   * Returns the right-handed rotation about an axis (Rodrigues' formula).
   *
   * @param axis unit vector
   * @param angle rad
   */
  public static Rotation about(Vector3 axis, double angle) {
    double s = StrictMath.sin(angle);
    double c = StrictMath.cos(angle);
    return aboutAxis(axis, s, c, 1 - c);
  }

  /**
   * Returns the rotation of smallest angle with R · from = to.
   *
   * @param from unit vector
   * @param to unit vector
   * @throws ArithmeticException if the vectors are opposite, where every half turn about a normal
   *     would do
   */
  public static Rotation least(Vector3 from, Vector3 to) {
    double c = from.dot(to);
    if (c < OPPOSITE) {
      throw new ArithmeticException("opposite vectors leave the rotation between them open");
    }
    Vector3 k = from.cross(to);
    if (k.equals(Vector3.ZERO)) {
      return IDENTITY;
    }
    // R = c I + [k]x + k kᵀ / (1 + c), with k = from × to not normalised.
    double f = 1 / (1 + c);
    return new Rotation(
        c + f * k.x() * k.x(),
        f * k.x() * k.y() - k.z(),
        f * k.x() * k.z() + k.y(),
        f * k.x() * k.y() + k.z(),
        c + f * k.y() * k.y(),
        f * k.y() * k.z() - k.x(),
        f * k.x() * k.z() - k.y(),
        f * k.y() * k.z() + k.x(),
        c + f * k.z() * k.z());
  }

  /**
   * Returns the rotation whose columns are the given right-handed orthonormal axes.
   *
   * @param x first child axis in parent axes
   * @param y second child axis in parent axes
   * @param z third child axis in parent axes
   */
  public static Rotation ofColumns(Vector3 x, Vector3 y, Vector3 z) {
    return new Rotation(x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z());
  }

  private static Rotation aboutAxis(Vector3 u, double s, double c, double d) {
    return new Rotation(
        c + d * u.x() * u.x(),
        d * u.x() * u.y() - s * u.z(),
        d * u.x() * u.z() + s * u.y(),
        d * u.x() * u.y() + s * u.z(),
        c + d * u.y() * u.y(),
        d * u.y() * u.z() - s * u.x(),
        d * u.x() * u.z() - s * u.y(),
        d * u.y() * u.z() + s * u.x(),
        c + d * u.z() * u.z());
  }

  /** Returns the parent components of a vector given in child components. */
  public Vector3 apply(Vector3 v) {
    return new Vector3(
        xx * v.x() + xy * v.y() + xz * v.z(),
        yx * v.x() + yy * v.y() + yz * v.z(),
        zx * v.x() + zy * v.y() + zz * v.z());
  }

  /** Returns this · other. */
  public Rotation times(Rotation other) {
    return ofColumns(
        apply(new Vector3(other.xx, other.yx, other.zx)),
        apply(new Vector3(other.xy, other.yy, other.zy)),
        apply(new Vector3(other.xz, other.yz, other.zz)));
  }

  /** Returns the inverse rotation. */
  public Rotation transposed() {
    return new Rotation(xx, yx, zx, xy, yy, zy, xz, yz, zz);
  }
}
