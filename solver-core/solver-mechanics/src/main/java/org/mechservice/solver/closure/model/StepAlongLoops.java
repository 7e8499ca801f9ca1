package org.mechservice.solver.closure.model;

/**
 * The equations of an implicit step, restricted to motions along the loops:
 *
 * <pre>Rᵀ A R Δv_I = Rᵀ r,   Δv = R Δv_I   where   J R = 0</pre>
 *
 * <p>with A the iteration matrix of the open tree. Workspace of one thread.
 */
abstract sealed class StepAlongLoops permits DenseStepAlongLoops, SparseStepAlongLoops {
  /** Result of {@link #factor} if there are pivots for all velocities. */
  static final int REGULAR = -1;

  /** Takes up J at the placed state. */
  void linearise() {}

  /**
   * Forms and factors the equations; the partition and J are those of the linearisation.
   *
   * @param hGamma hγ, s
   * @return {@link #REGULAR}, or a velocity without a pivot
   */
  abstract int factor(double hGamma);

  /**
   * Solves with the last factors.
   *
   * @param ofIndependent further right-hand side of the independent velocities, in the order of the
   *     partition; overwritten
   * @param change right-hand side r, n numbers; overwritten with Δv
   */
  abstract void solve(double[] ofIndependent, double[] change);
}
