package org.mechservice.mechml;

/**
 * Absolute error tolerances, one for each class of state.
 *
 * @param position of displacements, m
 * @param angle of angles, rad, and of Euler parameters
 * @param velocity of rates of displacements, m/s
 * @param angularVelocity of angular velocities, rad/s
 */
public record AbsoluteTolerances(
    double position, double angle, double velocity, double angularVelocity) {

  /** Returns the same for all states. */
  public static AbsoluteTolerances uniform(double tolerance) {
    return new AbsoluteTolerances(tolerance, tolerance, tolerance, tolerance);
  }
}
