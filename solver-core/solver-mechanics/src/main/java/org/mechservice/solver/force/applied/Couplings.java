package org.mechservice.solver.force.applied;

/** Takes the pairs of links that forces couple. */
public interface Couplings {
  /**
   * A force on one link depends on the other, so that the Jacobian has entries where both ways to
   * the root meet.
   *
   * @param on link of the force, not the root
   * @param by link it depends on, not the root
   */
  void couple(int on, int by);
}
