package org.mechservice.solver.api.capability;

/** A model of closed loops that can continue from a state in which an event has set components. */
public interface StateJumps {
  /**
   * Closes the loops after a jump. Components that were set are kept if the loops permit it; other
   * positions move by the least change in the metric of the mass matrix, and other velocities
   * change as by an impulse along the constraints.
   *
   * @param t time, s
   * @param y state; overwritten
   * @param set whether each component was set; not modified
   * @return false if the loops cannot be closed; {@link Defects#obstacle} then gives the reason
   */
  boolean jump(double t, double[] y, boolean[] set);
}
