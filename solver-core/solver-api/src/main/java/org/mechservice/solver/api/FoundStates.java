package org.mechservice.solver.api;

/**
 * A model whose states are found one by one, without integration: positions that follow prescribed
 * motions, equilibria.
 */
public interface FoundStates extends ExplicitModel, Defects {
  /**
   * Finds the state at an output time.
   *
   * @param t time, s; not before that of the last call
   * @param y overwritten with the state [q; v]; {@link #derivative} holds for it until the next
   *     call
   * @return {@link #REGULAR}, or {@link Defects#DEFECT} if there is none
   */
  int find(double t, double[] y);

  /** Returns how many corrections were made in all. */
  long iterations();
}
