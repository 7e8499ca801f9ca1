package org.mechservice.solver.api.capability;

/**
 * A model of closed loops integrated in independent coordinates: the others follow from them
 * (NUMERICS §3). The integrator carries all, tests the independent ones.
 */
public interface DependentStates {
  /** Returns whether a component of the state is independent at present. */
  boolean independent(int component);

  /**
   * Overwrites the dependent components so that loops are closed.
   *
   * @param t time, s
   * @param y state; independent components are kept, dependent ones are starting values at entry
   * @return false if the loops cannot be closed there
   */
  boolean complete(double t, double[] y);

  /**
   * Takes note of an accepted step and may choose other components as independent.
   *
   * @return whether the choice has changed
   */
  boolean accepted(double t, double[] y);
}
