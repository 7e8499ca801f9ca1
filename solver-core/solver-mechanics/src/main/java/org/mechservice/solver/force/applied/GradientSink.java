package org.mechservice.solver.force.applied;

/** Takes the derivative of one number by what it depends on, piece by piece. */
public interface GradientSink {
  /** By the place and velocity of a link: 6 numbers each, as in {@link ForceJacobian}. */
  void byLink(int link, double[] byPlace, double[] byVelocity);

  /** By an extended coordinate. */
  void byCoordinate(int coordinate, double byPlace, double byVelocity);
}
