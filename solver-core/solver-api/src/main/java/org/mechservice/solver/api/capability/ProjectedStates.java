package org.mechservice.solver.api.capability;

/** A model whose states are projected onto its constraints within every step. */
public interface ProjectedStates {
  /**
   * Projects a state onto the constraints, positions before velocities, by the least change in the
   * metric of the mass matrix.
   *
   * @param t time, s
   * @param y state; overwritten
   * @return false if the loops cannot be closed
   */
  boolean project(double t, double[] y);

  /**
   * Records an accepted step.
   *
   * @param t its end, s
   * @param y projected state; not modified
   */
  default void accepted(double t, double[] y) {}
}
