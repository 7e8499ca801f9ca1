package org.mechservice.sim.equations.links;

import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.ScalarVector;

/**
 * A motion seen at the origin of the frame it is given in: a velocity, its rate, or one per
 * coordinate.
 *
 * @param angular rad/s
 * @param linear of the point of the body at the origin, m/s
 */
public record Twist(ScalarVector angular, ScalarVector linear) {

  public Twist plus(Twist other) {
    return new Twist(angular.plus(other.angular), linear.plus(other.linear));
  }

  /** Returns this × other: how a motion fixed in a frame changes that moves like this. */
  public Twist cross(Twist other) {
    return new Twist(
        angular.cross(other.angular),
        angular.cross(other.linear).plus(linear.cross(other.angular)));
  }

  /** Returns the power of a wrench at the same origin. */
  public Scalar dot(Wrench wrench) {
    return angular.dot(wrench.moment()).plus(linear.dot(wrench.force()));
  }

  /** Returns this ×* wrench: how a wrench fixed in a frame changes that moves like this. */
  public Wrench cross(Wrench wrench) {
    return new Wrench(
        angular.cross(wrench.moment()).plus(linear.cross(wrench.force())),
        angular.cross(wrench.force()));
  }
}
