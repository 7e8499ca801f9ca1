package org.mechservice.solver.ode;

/**
 * A residual system that knows its own linear algebra: it keeps ∂F/∂y and ∂F/∂y' in whatever form
 * suits it and solves with (hγ ∂F/∂y + ∂F/∂y'). A mechanism reduces the 2n equations of [q; v] to n
 * this way and eliminates along its tree
 * (docs/theory/formulations.md#rr-jf-the-jacobian-by-recursion).
 *
 * <p>The derivatives stay those of the last {@link #linearise} while hγ changes; each change of hγ
 * costs a {@link #factor}.
 */
public interface LinearisedSystem extends ResidualSystem {
  /**
   * Evaluates and keeps ∂F/∂y and ∂F/∂y'.
   *
   * @return false if one of them is not finite
   */
  boolean linearise(double t, double[] y, double[] yDot);

  /**
   * Factors hγ ∂F/∂y + ∂F/∂y'.
   *
   * @return false if the matrix is singular
   */
  boolean factor(double hGamma);

  /**
   * Solves (hγ ∂F/∂y + ∂F/∂y') d = r with the last factors.
   *
   * @param r right-hand side at entry, d at return
   */
  void solve(double[] r);

  /**
   * Solves ∂F/∂y' d = r; the last factors stay.
   *
   * @param r right-hand side at entry, d at return
   * @return false, with r as it was, if ∂F/∂y' is singular or not kept by itself
   */
  default boolean solveForDerivative(double[] r) {
    return false;
  }

  /**
   * Returns an estimate of the reciprocal condition of the matrix factored last, free of the units
   * of the equations, for the diagnosis of a failure; 1 if nothing is known of it.
   */
  default double reciprocalCondition() {
    return 1;
  }

  /** Returns the component at whose column the last {@link #factor} failed. */
  int singularComponent();
}
