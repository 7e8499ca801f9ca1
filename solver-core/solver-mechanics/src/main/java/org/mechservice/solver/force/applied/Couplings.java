package org.mechservice.solver.force.applied;

/** Receives the pairs of links that forces couple. */
public interface Couplings {
  /**
   * Adds a pair: the force on one link depends on the other, so that the Jacobian couples the
   * ancestors of both.
   *
   * @param on link of the force, not the root
   * @param by link it depends on, not the root
   */
  void couple(int on, int by);
}
