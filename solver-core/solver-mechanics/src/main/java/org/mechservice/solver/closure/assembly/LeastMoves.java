package org.mechservice.solver.closure.assembly;

import org.mechservice.solver.linear.SparseMatrix;

/**
 * The smallest solution of linear equations that may repeat each other. Workspace of one thread.
 */
interface LeastMoves {
  /** Takes other equations, of the pattern that it was made for; not modified. */
  void take(SparseMatrix matrix);

  /**
   * Solves A x ≈ b with the least error and, among those, the smallest x; or, damped, (AᵀA + μ σ²)
   * x = Aᵀ b, σ² being about the square of A's size.
   *
   * @param damping μ, zero for none
   * @param right b; not modified
   * @param x overwritten
   */
  void solve(double damping, double[] right, double[] x);
}
