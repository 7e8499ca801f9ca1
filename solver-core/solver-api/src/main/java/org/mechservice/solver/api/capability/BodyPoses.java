package org.mechservice.solver.api.capability;

import java.util.List;

/**
 * A model built with the column group {@code bodies}: it computes poses and velocities of its
 * bodies.
 */
public interface BodyPoses {
  /** Numbers per body: x, y, z, e0, e1, e2, e3, vx, vy, vz, wx, wy, wz. */
  int NUMBERS_PER_BODY = 13;

  /** Returns the names of the moving bodies, in file order. */
  List<String> bodies();

  /**
   * Evaluates the pose of every body frame and the velocity of its origin, in world axes.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   * @param poses per body {@link #NUMBERS_PER_BODY} numbers: position of the frame's origin from
   *     the world origin, m; Euler parameters (body to world, unit norm, e0 ≥ 0); velocity of the
   *     origin, m/s; angular velocity, rad/s; overwritten
   */
  void poses(double t, double[] y, double[] poses);
}
