package org.mechservice.solver.force.applied;

/** A force on one coordinate as a function of its position and velocity. */
public interface ScalarLaw {
  /**
   * Sets the coefficients.
   *
   * @param force receives the defect of an unusable coefficient
   * @return false if they cannot be used
   */
  boolean parameters(double[] values, AppliedForce force);

  /** Evaluates the force and its derivatives. */
  void evaluate(double position, double velocity);

  /** Returns the force; a positive force increases the coordinate. */
  double force();

  double byPosition();

  double byVelocity();

  double potentialEnergy(double position);

  /** Returns the rate of the potential energy. */
  double energyRate(double velocity);
}
