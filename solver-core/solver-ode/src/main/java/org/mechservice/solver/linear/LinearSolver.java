package org.mechservice.solver.linear;

/**
 * Solves A x = b for one matrix after another, all of the same size and layout.
 *
 * <pre>{@code
 * if (solver.factor(a) == LinearSolver.NONSINGULAR) {
 *   solver.solve(b);
 * }
 * }</pre>
 *
 * <p>A solver is a workspace for one thread; none of its methods allocates memory.
 */
public interface LinearSolver {
  /** Result of {@link #factor} if all pivots differ from zero. */
  int NONSINGULAR = -1;

  /** Returns size and storage of the matrices. */
  MatrixLayout layout();

  /**
   * Factors a matrix; what was factored before is forgotten.
   *
   * @param matrix its elements, length {@code layout().length()}; not modified
   * @return {@link #NONSINGULAR}, or the first column, from 0, in which no pivot is left: none that
   *     is finite and at least {@link Double#MIN_NORMAL}
   * @throws IllegalArgumentException if the array's length is not that of the layout
   */
  int factor(double[] matrix);

  /**
   * Solves A x = b.
   *
   * @param b right-hand side, length {@code layout().dimension()}; overwritten with x
   * @throws IllegalStateException if no matrix was factored or the last one is singular
   */
  void solve(double[] b);

  /**
   * Returns an estimate of 1 / (‖A‖ ‖A⁻¹‖) in the norm of the largest row sum, between 0 and 1: 1
   * loses no digits, 1e-12 loses twelve, 0 is singular. Seldom more than three times too large, and
   * does not depend on the unit of A as a whole. Costs some eight solutions.
   */
  double reciprocalCondition();
}
