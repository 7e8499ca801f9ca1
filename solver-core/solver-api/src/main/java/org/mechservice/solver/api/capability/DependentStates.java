package org.mechservice.solver.api.capability;

/**
 * A model of closed loops integrated in independent coordinates, which determine the others
 * (docs/theory/loops.md#projection). The integrator carries all coordinates and applies the error
 * test to the independent ones, and to those that {@link #tested} names.
 */
public interface DependentStates {
  /** Returns whether a component of the state is independent at present. */
  boolean independent(int component);

  /**
   * Returns whether a component is tested for error. Independent ones are; dependent ones need it
   * where time moves them: the independent ones then do not show how fast they move.
   */
  default boolean tested(int component) {
    return independent(component);
  }

  /**
   * Enlarges the sizes of dependent components, to which the errors allowed in them are relative:
   * they carry the rounding errors of all coordinates.
   *
   * @param sizes one per component; those of dependent ones may be enlarged
   */
  default void enlarge(double[] sizes) {}

  /**
   * Overwrites the dependent components so that loops are closed.
   *
   * @param t time, s
   * @param y state; independent components are kept, dependent ones are starting values at entry
   * @return false if the loops cannot be closed
   */
  boolean complete(double t, double[] y);

  /**
   * Records an accepted step; may choose other components as independent.
   *
   * @return whether the choice has changed
   */
  boolean accepted(double t, double[] y);
}
