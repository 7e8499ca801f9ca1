package org.mechservice.solver.api;

/**
 * The state at which a {@link UserForce} is evaluated. Vectors have three components in world axes
 * unless stated otherwise; SI units. Reading an undeclared quantity throws an {@link
 * IllegalStateException}.
 */
public interface ForceState {
  /** Returns the time, s. */
  double time();

  /** Returns a tunable parameter, SI units. */
  double parameter(int parameter);

  /**
   * Returns the position of a coordinate, rad or m.
   *
   * @throws IllegalStateException if it has no position: rotations of spherical and free joints
   */
  double coordinate(int coordinate);

  /** Returns the rate of a coordinate, rad/s or m/s. */
  double rate(int coordinate);

  /**
   * Writes the position of a point from the world's origin, m.
   *
   * @param out overwritten
   */
  void position(int point, double[] out);

  /**
   * Writes the velocity of a point, m/s.
   *
   * @param out overwritten
   */
  void velocity(int point, double[] out);

  /**
   * Writes the rotation of a point's body, from body axes to world axes, row by row.
   *
   * @param out nine numbers; overwritten
   */
  void rotation(int point, double[] out);

  /**
   * Writes the angular velocity of a point's body, rad/s.
   *
   * @param out overwritten
   */
  void angularVelocity(int point, double[] out);
}
