package org.mechservice.solver.api.capability;

/**
 * A model that computes each state from algebraic equations, without integration: positions that
 * follow prescribed motions, equilibria.
 */
public interface AlgebraicModel extends ExplicitModel, Defects {
  /**
   * Prepares for the states of a run, before the first of them.
   *
   * @param from start time, s
   * @param to end time, s
   */
  default void begin(double from, double to) {}

  /**
   * Finds the state at an output time.
   *
   * @param t time, s; not before the time of the last call
   * @param y overwritten with the state [q; v]; {@link #derivative} is valid for it until the next
   *     call
   * @return {@link #REGULAR}, or {@link Defects#DEFECT} if there is none
   */
  int find(double t, double[] y);

  /** Returns the total number of corrections. */
  long iterations();
}
