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
   * Removes from the estimated error of a step what the projection of velocities removes, too: the
   * part of its velocities that violates the constraints, by the least change in the metric of the
   * mass matrix.
   *
   * @param t end of the step, s
   * @param y state there; not modified
   * @param error of the states; overwritten
   * @return false if the mass matrix is singular there; the error is then as it was
   */
  boolean projectError(double t, double[] y, double[] error);

  /**
   * Records an accepted step.
   *
   * @param t its end, s
   * @param y projected state; not modified
   */
  default void accepted(double t, double[] y) {}
}
