package org.mechservice.solver.api.capability;

/**
 * A residual model with its Jacobian and its own linear solver, which eliminates along the tree and
 * reduces the 2n equations of [q; v] to n
 * (docs/theory/formulations.md#rr-jf-the-jacobian-by-recursion).
 */
public interface LinearisedModel extends ResidualModel {
  /**
   * Evaluates and stores ∂F/∂y and ∂F/∂y'.
   *
   * @return false if one of them is not finite
   */
  boolean linearise(double t, double[] y, double[] yDot);

  /**
   * Factors hγ ∂F/∂y + ∂F/∂y', hγ in s.
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
   * @return false, with r as it was, if ∂F/∂y' is singular or not stored separately
   */
  default boolean solveForDerivative(double[] r) {
    return false;
  }

  /** Returns the unknown at whose column the last {@link #factor} failed, an index into y. */
  int singularUnknown();
}
