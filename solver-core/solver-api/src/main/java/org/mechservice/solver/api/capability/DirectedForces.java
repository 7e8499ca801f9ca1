package org.mechservice.solver.api.capability;

/**
 * A generated model with forces that have no direction in some positions: a spring under tension
 * whose points coincide, a bushing turned by half a turn. An evaluation there returns {@link
 * #result} of the force.
 */
public interface DirectedForces {
  /** What an evaluation returns for force 0; for others less. */
  int FIRST = -3;

  /** Returns what an evaluation returns for a force, by its place in the file. */
  static int result(int force) {
    return FIRST - force;
  }

  /** Returns the force for which an evaluation returned a result. */
  static int force(int result) {
    return FIRST - result;
  }

  /**
   * Returns the name of a force that can lose its direction.
   *
   * @param force its place in the file
   */
  String directedForce(int force);
}
