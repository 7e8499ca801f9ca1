package org.mechservice.view.scene;

/**
 * The pose of a body in the world.
 *
 * @param position the body's origin from the world's origin, in world axes, m
 * @param e0 scalar part of the Euler parameters that turn body axes to world axes
 * @param e1 x of their vector part
 * @param e2 y of it
 * @param e3 z of it
 */
public record BodyPose(Point3 position, double e0, double e1, double e2, double e3) {
  /** At the world's origin, with its axes. */
  public static final BodyPose WORLD = new BodyPose(Point3.ZERO, 1, 0, 0, 0);

  /**
   * Returns the pose with a rotation matrix from body axes to world axes.
   *
   * @param a the matrix row by row, 9 numbers from {@code at}
   */
  public static BodyPose of(Point3 position, double[] a, int at) {
    double xx = a[at];
    double yy = a[at + 4];
    double zz = a[at + 8];
    // the largest of the four is not near zero: Shepperd 1978
    double[] square = {1 + xx + yy + zz, 1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz};
    int largest = 0;
    for (int i = 1; i < 4; i++) {
      largest = square[i] > square[largest] ? i : largest;
    }
    double twice = Math.sqrt(square[largest]);
    double d = 1 / (2 * twice);
    double x = a[at + 7] - a[at + 5];
    double y = a[at + 2] - a[at + 6];
    double z = a[at + 3] - a[at + 1];
    double xy = a[at + 1] + a[at + 3];
    double xz = a[at + 2] + a[at + 6];
    double yz = a[at + 5] + a[at + 7];
    return switch (largest) {
      case 0 -> new BodyPose(position, twice / 2, x * d, y * d, z * d);
      case 1 -> new BodyPose(position, x * d, twice / 2, xy * d, xz * d);
      case 2 -> new BodyPose(position, y * d, xy * d, twice / 2, yz * d);
      default -> new BodyPose(position, z * d, xz * d, yz * d, twice / 2);
    };
  }

  /** Returns a pose that is given in the axes of this one, in the axes that this one is in. */
  public BodyPose times(BodyPose inner) {
    return new BodyPose(
        toWorld(inner.position),
        e0 * inner.e0 - e1 * inner.e1 - e2 * inner.e2 - e3 * inner.e3,
        e0 * inner.e1 + e1 * inner.e0 + e2 * inner.e3 - e3 * inner.e2,
        e0 * inner.e2 - e1 * inner.e3 + e2 * inner.e0 + e3 * inner.e1,
        e0 * inner.e3 + e1 * inner.e2 - e2 * inner.e1 + e3 * inner.e0);
  }

  /** Returns the point with these coordinates in body axes, from the world's origin, m. */
  public Point3 toWorld(Point3 inBody) {
    return position.plus(turn(inBody));
  }

  /** Returns a direction given in body axes in world axes. */
  public Point3 turn(Point3 inBody) {
    // v + 2 e × (e × v + e0 v)
    Point3 e = new Point3(e1, e2, e3);
    return inBody.plus(e.cross(e.cross(inBody).plus(inBody.times(e0))).times(2));
  }

  /** Returns a vector, given in world axes, in the body's axes. */
  public Point3 turnBack(Point3 inWorld) {
    return new BodyPose(Point3.ZERO, e0, -e1, -e2, -e3).turn(inWorld);
  }
}
