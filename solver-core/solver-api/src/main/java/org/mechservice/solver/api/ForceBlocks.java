package org.mechservice.solver.api;

/**
 * Receives the derivatives of a {@link UserForce}. All components are in world axes; a rotation is
 * a small rotation vector of the body in world axes. Derivatives are partial: the derivative by the
 * position of a point holds its velocity constant.
 */
public interface ForceBlocks {
  /** The differentiated load. */
  enum Load {
    /** A force at a point: 3 rows. */
    FORCE,
    /** A torque on a point's body: 3 rows. */
    TORQUE,
    /** A force in a joint: 1 row. */
    JOINT_FORCE
  }

  /**
   * Adds a derivative by a reading of a point.
   *
   * @param load the differentiated load
   * @param on point or coordinate of the load
   * @param by the reading, which must have been declared
   * @param point point of the reading
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
