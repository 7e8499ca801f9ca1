package org.mechservice.solver.api.capability;

/**
 * A generated model with forces that have no direction in some positions: a spring under tension
 * whose points coincide, a bushing turned by half a turn. An evaluation there returns {@link
 * #result} of the force.
 */
public interface DirectedForces {
  /** Result of an evaluation for force 0; lower numbers for the others. */
  int FIRST = -3;

  /** Returns the result of an evaluation for a force, by its index in the file. */
  static int result(int force) {
    return FIRST - force;
  }

  /** Returns the force of a result. */
  static int force(int result) {
    return FIRST - result;
  }

  /**
   * Returns the name of a force that can lose its direction.
   *
   * @param force its index in the file
   */
  String directedForce(int force);
}
