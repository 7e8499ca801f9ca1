package org.mechservice.solver.force.applied;

import org.mechservice.solver.force.ForceSet;

/**
 * Receives the derivatives of applied forces by motions of links and by coordinates, term by term.
 *
 * <p>A wrench is [moment; force] in the axes of its link at the link's reference point, as {@link
 * ForceSet#apply} gives it; its derivatives are those of these six components. The receiver adds
 * the derivative of the joint forces of a wrench that is constant in its link's axes. A derivative
 * by a pose is taken for a small twist [rotation; displacement of the reference point] in link
 * axes, with the components of the link's velocity [angular; linear] in link axes held constant. A
 * coordinate is an index among the extended velocities; its small displacement is along the tangent
 * (docs/theory/motion.md#positions) and changes the force directly, not through the motion of
 * links.
 *
 * <p>Callers reuse the arrays, so implementations must copy them.
 */
public interface ForceJacobian {
  /**
   * Adds the derivative of the wrench on a link by the pose and velocity of a link.
   *
   * @param on link of the wrench
   * @param by link that moves; may be the same
   * @param byPlace 6 × 6 row by row, N·m/rad, N·m/m, N/rad, N/m
   * @param byVelocity 6 × 6 row by row, the same per s⁻¹
   */
  void wrenchByLink(int on, int by, double[] byPlace, double[] byVelocity);

  /**
   * Adds the derivative of the wrench on a link by a coordinate.
   *
   * @param byPlace 6 numbers, per rad or m
   * @param byVelocity 6 numbers, per rad/s or m/s
   */
  void wrenchByCoordinate(int on, int by, double[] byPlace, double[] byVelocity);

  /**
   * Adds the derivative of a joint force by the pose and velocity of a link.
   *
   * @param on coordinate of the force
   * @param byPlace 6 numbers, per rad, m
   * @param byVelocity 6 numbers, per rad/s, m/s
   */
  void forceByLink(int on, int by, double[] byPlace, double[] byVelocity);

  /**
   * Adds the derivative of a joint force by a coordinate.
   *
   * @param on coordinate of the force
   * @param byPlace per rad or m
   * @param byVelocity per rad/s or m/s
   */
  void forceByCoordinate(int on, int by, double byPlace, double byVelocity);
}
