package org.mechservice.solver.kinematics.pair;

import org.mechservice.solver.spatial.Vector3;

/**
 * A wheel or ball of body B on a plane of body A.
 *
 * @param normal unit vector normal to the plane, towards the wheel, in A's axes
 * @param axle unit vector along the wheel's axle, in B's axes; zero for a ball
 * @param radius of the ball or of the circle of the rim, m
 * @param tube radius of the rim's cross-section, m
 */
public record RollingShape(Vector3 normal, Vector3 axle, double radius, double tube) {
  /** Directions in which a contact restricts the velocity of the touching point. */
  public enum Direction {
    /** Normal to the plane; the only one with an equation of positions. */
    OFF("displacement off the plane"),
    /** In the plane along the wheel's track; for a ball the first tangent of the plane. */
    ALONG("slip along the track"),
    /** In the plane across the track, to the left with the normal upwards. */
    ACROSS("slip across the track");

    final String label;

    Direction(String label) {
      this.label = label;
    }
  }

  /** Returns whether a ball rolls, not a wheel. */
  public boolean isBall() {
    return axle.equals(Vector3.ZERO);
  }

  /** Returns the first tangent of the plane, in A's axes. */
  public Vector3 tangent() {
    return JointFunctions.normalTo(normal);
  }
}
