package org.mechservice.robot;

import java.util.List;
import org.mechservice.solver.spatial.Vector3;

/**
 * A body of even density, or an even shell: its volume, and its moments for a unit of mass.
 *
 * @param volume m³; of a shell its area, m²
 * @param centre centre of mass, m
 * @param moments xx, yy, zz, xy, xz, yz of the tensor about the centre for 1 kg, m²
 */
record UniformShape(double volume, Vector3 centre, List<Double> moments) {
  private static UniformShape about(double volume, double xx, double yy, double zz) {
    return new UniformShape(volume, Vector3.ZERO, List.of(xx, yy, zz, 0.0, 0.0, 0.0));
  }

  /** Returns an ellipsoid with its semi-axes along x, y and z, m. */
  static UniformShape ellipsoid(double a, double b, double c) {
    return about(
        4 * Math.PI / 3 * a * b * c, (b * b + c * c) / 5, (a * a + c * c) / 5, (a * a + b * b) / 5);
  }

  /** Returns a box with its half edges along x, y and z, m. */
  static UniformShape box(double a, double b, double c) {
    return about(8 * a * b * c, (b * b + c * c) / 3, (a * a + c * c) / 3, (a * a + b * b) / 3);
  }

  /** Returns a cylinder along z with a radius and half its length, m. */
  static UniformShape cylinder(double r, double h) {
    double across = r * r / 4 + h * h / 3;
    return about(2 * Math.PI * r * r * h, across, across, r * r / 2);
  }

  /**
   * Returns a cylinder along z with two half spheres, whose centres of mass are 3r/8 from their
   * discs.
   *
   * @param h half the length of the cylinder, m
   */
  static UniformShape capsule(double r, double h) {
    double tube = 2 * Math.PI * r * r * h;
    double balls = 4 * Math.PI / 3 * r * r * r;
    double across =
        tube * (r * r / 4 + h * h / 3) + balls * (2 * r * r / 5 + h * h + 3 * r * h / 4);
    double along = tube * r * r / 2 + balls * 2 * r * r / 5;
    double volume = tube + balls;
    return about(volume, across / volume, across / volume, along / volume);
  }

  /**
   * Returns a cone along z, pointed above, whose frame is in the middle of its height.
   *
   * @param h its height, m
   */
  static UniformShape cone(double r, double h) {
    double across = 3 * r * r / 20 + 3 * h * h / 80;
    return new UniformShape(
        Math.PI * r * r * h / 3,
        new Vector3(0, 0, -h / 4),
        List.of(across, across, 3 * r * r / 10, 0.0, 0.0, 0.0));
  }

  /** Returns the shell of a sphere. */
  static UniformShape sphereShell(double r) {
    double m = 2 * r * r / 3;
    return about(4 * Math.PI * r * r, m, m, m);
  }

  /** Returns the shell of a box with half edges a, b and c, m: six plates. */
  static UniformShape boxShell(double a, double b, double c) {
    double x = 8 * b * c;
    double y = 8 * a * c;
    double z = 8 * a * b;
    double area = x + y + z;
    // The mean of each coordinate's square over the plates.
    double xx = (x * a * a + (y + z) * a * a / 3) / area;
    double yy = (y * b * b + (x + z) * b * b / 3) / area;
    double zz = (z * c * c + (x + y) * c * c / 3) / area;
    return about(area, yy + zz, xx + zz, xx + yy);
  }

  /** Returns the closed shell of a cylinder along z with half its length h. */
  static UniformShape cylinderShell(double r, double h) {
    double discs = 2 * Math.PI * r * r;
    double side = 4 * Math.PI * r * h;
    double area = discs + side;
    double square = (discs * r * r / 4 + side * r * r / 2) / area;
    double zz = (discs * h * h + side * h * h / 3) / area;
    return about(area, square + zz, square + zz, 2 * square);
  }

  /** Returns the shell of a capsule along z; h is half the length of its cylinder. */
  static UniformShape capsuleShell(double r, double h) {
    double balls = 4 * Math.PI * r * r;
    double side = 4 * Math.PI * r * h;
    double area = balls + side;
    double square = (balls * r * r / 3 + side * r * r / 2) / area;
    // Over a half sphere the mean height is r/2 and the mean of its square r²/3.
    double zz = (balls * (h * h + h * r + r * r / 3) + side * h * h / 3) / area;
    return about(area, square + zz, square + zz, 2 * square);
  }
}
