package org.mechservice.solver.force;

/** Takes the derivative of one number by what it depends on, piece by piece. */
interface GradientSink {
  /** By the place and velocity of a link: 6 numbers each, as in {@link ForceJacobian}. */
  void byLink(int link, double[] byPlace, double[] byVelocity);

  /** By an extended coordinate. */
  void byCoordinate(int coordinate, double byPlace, double byVelocity);
}
