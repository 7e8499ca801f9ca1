package org.mechservice.solver.api;

/**
 * Takes the derivatives of a {@link UserForce}. Everything is in world axes; a rotation is a small
 * rotation vector of the body in world axes. Derivatives by one thing hold all others: by the
 * position of a point, its velocity is held.
 */
public interface ForceBlocks {
  /** What a derivative is of. */
  enum Load {
    /** A force at a point: 3 rows. */
    FORCE,
    /** A torque on a point's body: 3 rows. */
    TORQUE,
    /** A force in a joint: 1 row. */
    JOINT_FORCE
  }

  /**
   * Adds a derivative by what is read of a point.
   *
   * @param load what
   * @param on the point, or coordinate, that it is added to
   * @param by which reading; it must have been declared
   * @param point of the point
   * @param block 3 × 3 row by row, or 3 numbers for a joint force; not modified
   */
  void byPoint(Load load, int on, ForceDeclaration.Reads by, int point, double[] block);

  /**
   * Adds a derivative by a coordinate.
   *
   * @param byPosition 3 numbers, or 1 for a joint force; not modified
   * @param byRate likewise
   */
  void byCoordinate(Load load, int on, int coordinate, double[] byPosition, double[] byRate);
}
