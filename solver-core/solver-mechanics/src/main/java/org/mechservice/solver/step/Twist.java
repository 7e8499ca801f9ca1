package org.mechservice.solver.step;

import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * A spatial motion at the origin of its frame: a velocity, its rate, or a velocity per coordinate.
 *
 * @param angular rad/s
 * @param linear of the point of the body at the origin, m/s
 */
public record Twist(ScalarVector angular, ScalarVector linear) {

  public Twist plus(Twist other) {
    return new Twist(angular.plus(other.angular), linear.plus(other.linear));
  }

  /**
   * Returns this × other: the rate of a motion that is fixed in a frame moving with this velocity.
   */
  public Twist cross(Twist other) {
    return new Twist(
        angular.cross(other.angular),
        angular.cross(other.linear).plus(linear.cross(other.angular)));
  }

  /** Returns the power of a wrench at the same origin. */
  public Scalar dot(Wrench wrench) {
    return angular.dot(wrench.moment()).plus(linear.dot(wrench.force()));
  }

  /**
   * Returns this ×* wrench: the rate of a wrench that is fixed in a frame moving with this
   * velocity.
   */
  public Wrench cross(Wrench wrench) {
    return new Wrench(
        angular.cross(wrench.moment()).plus(linear.cross(wrench.force())),
        angular.cross(wrench.force()));
  }
}
