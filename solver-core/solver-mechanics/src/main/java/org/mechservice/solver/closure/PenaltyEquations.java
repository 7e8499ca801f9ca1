package org.mechservice.solver.closure;

/**
 * The equations M x + Jᵀ λ = r, J x + c = 0 at a sequence of states, solved by the augmented
 * Lagrangian method, which admits redundant equations. Velocities may be held fixed: their x is
 * zero. Workspace of one thread.
 */
public interface PenaltyEquations {
  /**
   * Factors at the placed state.
   *
   * @param held velocities that must not change; empty if none can be held
   * @return a negative number, or the index of a velocity without inertia
   */
  int factor(boolean[] held);

  /**
   * Solves with the last factors.
   *
   * @param right r, one number per velocity; not modified
   * @param offset c, one number per loop equation, divided by its size; not modified
   * @param x from {@code at}; overwritten
   */
  void solve(double[] right, double[] offset, double[] x, int at);

  /** Returns λ of the last solution, for equations divided by their sizes; must not be modified. */
  double[] multipliers();
}
