package org.mechservice.solver.force.applied;

/** Receives the gradient of one number by motions of links and by coordinates, term by term. */
public interface GradientSink {
  /**
   * Adds the derivative by the pose and velocity of a link: 6 numbers each, as in {@link
   * ForceJacobian}.
   */
  void byLink(int link, double[] byPlace, double[] byVelocity);

  /** Adds the derivative by an extended coordinate. */
  void byCoordinate(int coordinate, double byPlace, double byVelocity);
}
