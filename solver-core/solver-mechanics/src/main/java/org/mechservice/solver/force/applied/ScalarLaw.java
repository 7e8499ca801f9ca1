package org.mechservice.solver.force.applied;

/** A force on one coordinate as a function of its position and velocity. */
public interface ScalarLaw {
  /**
   * Takes the coefficients.
   *
   * @param force told what is wrong with them
   * @return false if they cannot be used
   */
  boolean parameters(double[] values, AppliedForce force);

  /** Evaluates the force and its derivatives. */
  void evaluate(double position, double velocity);

  /** Returns the force; positive drives the coordinate upwards. */
  double force();

  double byPosition();

  double byVelocity();

  double potentialEnergy(double position);

  /** Returns the rate of the potential energy. */
  double energyRate(double velocity);
}
