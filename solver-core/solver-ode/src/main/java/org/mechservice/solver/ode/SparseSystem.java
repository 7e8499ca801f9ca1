package org.mechservice.solver.ode;

/**
 * A system that knows which components each equation has in it: ∂f_i/∂y_j, or in residual form
 * ∂F_i/∂y_j and ∂F_i/∂y'_j, vanish for the others. Implemented beside {@link OdeSystem} or {@link
 * ResidualSystem}.
 *
 * <p>Implicit methods then difference columns together that share no row, so that derivatives of a
 * ring of any length take three or four evaluations. Equations are still solved with a matrix that
 * is full, or a band if the problem is a {@link BandedSystem}, too.
 */
public interface SparseSystem {
  /**
   * Returns whether an equation has a component or its derivative in it. Asked once for every pair
   * when a problem is begun. For a {@link CompletedSystem} what counts is whether the component
   * moves the equation along completed states.
   *
   * @param equation i, from 0
   * @param component j, from 0
   */
  boolean couples(int equation, int component);
}
