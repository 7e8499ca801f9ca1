package org.mechservice.solver.closure.model;

/**
 * Factors of J U² Jᵀ, by which positions are moved back onto the loops: the shortest change, in the
 * coordinates' units, is U² Jᵀ (J U² Jᵀ)⁻¹ times the distance. Workspace of one thread.
 */
sealed interface PositionCorrection permits DensePositionCorrection, SparsePositionCorrection {
  /** Multiple of the largest element that is added to the diagonal, since rows of J may be zero. */
  double REGULAR_PART = 1e-10;

  /** Forms and factors the matrix; returns whether all pivots are more than rounding. */
  boolean factor();

  /** Solves J U² Jᵀ x = b; {@code b} is overwritten with x. */
  void solve(double[] b);

  /**
   * Returns what is added to the diagonal: omitted rows are zero, and so are all rows of loops
   * between bodies that cannot move.
   *
   * @param largest largest element of the diagonal
   */
  static double regularPart(double largest) {
    return REGULAR_PART * (largest > 0 ? largest : 1);
  }
}
