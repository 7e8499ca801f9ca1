package org.mechservice.solver.api.capability;

/** A model whose states are moved back onto its constraints within every step. */
public interface ProjectedStates {
  /**
   * Moves a state onto the constraints, positions before velocities, by the least change in the
   * metric of the mass matrix.
   *
   * @param t time, s
   * @param y state; overwritten
   * @return false if the loops cannot be closed there
   */
  boolean project(double t, double[] y);

  /**
   * Takes note of an accepted step.
   *
   * @param t its end, s
   * @param y projected state; not modified
   */
  default void accepted(double t, double[] y) {}
}
