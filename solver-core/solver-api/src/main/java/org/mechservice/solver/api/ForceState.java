package org.mechservice.solver.api;

/**
 * The state a {@link UserForce} is evaluated in. Vectors have three components in world axes unless
 * said otherwise; SI units. Reading what was not declared throws an {@link IllegalStateException}.
 */
public interface ForceState {
  /** Returns the time, s. */
  double time();

  /** Returns a tunable parameter, SI units. */
  double parameter(int parameter);

  /**
   * Returns the position of a coordinate, rad or m.
   *
   * @throws IllegalStateException if it has none of its own: rotations of spherical and free joints
   */
  double coordinate(int coordinate);

  /** Returns the rate of a coordinate, rad/s or m/s. */
  double rate(int coordinate);

  /**
   * Writes where a point is, from the world's origin, m.
   *
   * @param out overwritten
   */
  void position(int point, double[] out);

  /**
   * Writes how fast a point moves, m/s.
   *
   * @param out overwritten
   */
  void velocity(int point, double[] out);

  /**
   * Writes how a point's body is turned: the rotation from body axes to world axes, row by row.
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
