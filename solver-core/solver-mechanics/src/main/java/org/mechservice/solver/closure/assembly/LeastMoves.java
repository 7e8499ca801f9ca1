package org.mechservice.solver.closure.assembly;

import java.util.OptionalDouble;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.linear.SparseMatrix;

/** The least-norm solution of linear equations that may be redundant. Workspace of one thread. */
interface LeastMoves {
  /**
   * Returns the solution for the columns of J that belong to the state.
   *
   * @param columns number of velocities of the state
   */
  static LeastMoves of(LoopEquations loops, int columns, boolean isLarge) {
    return isLarge
        ? new SparseLeastMoves(loops.jacobian.sameShape(), columns)
        : new DenseLeastMoves(loops.count(), columns);
  }

  /** Sets a new matrix with the pattern given at construction; not modified. */
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

  /** Returns the ratio of the largest to the smallest singular value that counts, if known. */
  OptionalDouble largestOverSmallest();

  /**
   * Solves Aᵀ x ≈ b with the least error and, among those, the smallest x.
   *
   * @param right b; not modified
   * @param x overwritten
   */
  void solveTransposed(double[] right, double[] x);
}
