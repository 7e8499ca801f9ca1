package org.mechservice.solver.spatial;

/**
 * The point at which a string that runs through a ring touches it from inside.
 *
 * <p>The string goes from a point at the distance l₁ from the centre of a circle to one at the
 * distance l₂, with the angle ψ between their directions; both lie outside, and the straight line
 * between them does not meet the circle. The shortest way by a point of the circle leaves it at the
 * angle u from the radius to both sides. With A = radius / l₁ and B = radius / l₂
 *
 * <pre>
 * f(u) = ψ − 2 u + asin(A sin u) + asin(B sin u) = 0
 * </pre>
 *
 * which falls and is concave between 0 and π/2, so that Newton's method comes down from π/2 without
 * passing the root.
 */
public final class TouchingPoint {
  /** Most steps; beyond, rounding alone moves u. */
  private static final int STEPS = 100;

  private TouchingPoint() {}

  /**
   * Returns the angle at the centre from the first point to the touching point.
   *
   * @param l1 l₁, m, larger than the radius
   * @param l2 l₂, m, likewise
   * @param psi ψ, rad
   * @param radius of the circle, m
   * @param tolerance size of f at which the search ends, rad; 0: at the last digit
   */
  public static double angle(double l1, double l2, double psi, double radius, double tolerance) {
    double a = radius / l1;
    double b = radius / l2;
    double u = 0.5 * Math.PI;
    for (int i = 0; i < STEPS; i++) {
      double sine = StrictMath.sin(u);
      double cosine = StrictMath.cos(u);
      double f = psi - 2 * u + StrictMath.asin(a * sine) + StrictMath.asin(b * sine);
      double slope =
          -2
              + a * cosine / Math.sqrt(1 - a * a * sine * sine)
              + b * cosine / Math.sqrt(1 - b * b * sine * sine);
      double next = u - f / slope;
      if (Math.abs(f) <= tolerance || !(next < u)) {
        break;
      }
      u = next;
    }
    return u - StrictMath.asin(a * StrictMath.sin(u));
  }
}
