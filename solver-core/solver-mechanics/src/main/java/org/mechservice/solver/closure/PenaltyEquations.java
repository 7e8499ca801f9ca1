package org.mechservice.solver.closure;

/**
 * The equations M x + Jᵀ λ = r, J x + c = 0 at one placement after the other, by a penalty and
 * repetition: the augmented Lagrangian, to which equations that follow from others do no harm.
 * Velocities may be held, so that x is zero there. Workspace of one thread.
 */
public interface PenaltyEquations {
  /**
   * Factors where the work is placed.
   *
   * @param held velocities that must not change; empty if none can be held
   * @return a negative number, or the velocity that nothing resists
   */
  int factor(boolean[] held);

  /**
   * Solves with the last factors.
   *
   * @param right r, one number per velocity; not modified
   * @param offset c, one number per equation of the loops over its size; not modified
   * @param x from {@code at}; overwritten
   */
  void solve(double[] right, double[] offset, double[] x, int at);

  /** Returns λ of the last solution, for equations over their sizes; not to be modified. */
  double[] multipliers();
}
