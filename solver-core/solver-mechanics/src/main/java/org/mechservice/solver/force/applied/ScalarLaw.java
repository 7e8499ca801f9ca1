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

  /** Sets the time of the next {@link #force}, of which most laws are independent, s. */
  default void at(double t) {}

  /** Returns the force; a positive force increases the coordinate. */
  double force(double position, double velocity);

  /**
   * Differentiates the law at the state of the last {@link #force}.
   *
   * @param by derivatives by position and velocity; overwritten
   */
  void slopes(double[] by);

  /** Returns the derivative by a further state, likewise; most laws depend on none. */
  default double byState(int state) {
    return 0;
  }

  /** Returns the potential energy in the state of the last {@link #force}, J. */
  double potentialEnergy();

  /** Returns the power of the part without potential energy, likewise, W. */
  double power();
}
