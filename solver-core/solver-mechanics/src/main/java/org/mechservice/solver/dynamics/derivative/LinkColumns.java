package org.mechservice.solver.dynamics.derivative;

/**
 * Direct terms of the coordinates of the joints in the equations of {@link LinkJacobian}, whose
 * symbols these are: a column for each velocity.
 */
final class LinkColumns {
  /** Z, the motion of the link, 18 for each velocity. */
  final double[] motion;

  /** G, the wrench on the link, 6 for each velocity. */
  final double[] wrench;

  /** D, the forces in the joint, three for each velocity. */
  final double[] force;

  LinkColumns(int velocities) {
    motion = new double[PlacedLinks.WIDTH * velocities];
    wrench = new double[6 * velocities];
    force = new double[3 * velocities];
  }

  /** Returns the sum of all elements, which is finite if they are. */
  double sum() {
    return PlacedLinks.sum(motion) + PlacedLinks.sum(wrench) + PlacedLinks.sum(force);
  }
}
