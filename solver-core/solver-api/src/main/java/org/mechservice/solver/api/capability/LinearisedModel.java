package org.mechservice.solver.api.capability;

/**
 * A residual model that knows its Jacobian and how to solve with it: along the tree, with n
 * equations for the 2n of [q; v] (NUMERICS §2).
 */
public interface LinearisedModel extends ResidualModel {
  /**
   * Evaluates and keeps ∂F/∂y and ∂F/∂y'.
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
   * @return false, with r as it was, if ∂F/∂y' is singular or not kept by itself
   */
  default boolean solveForDerivative(double[] r) {
    return false;
  }

  /** Returns the unknown at whose column the last {@link #factor} failed. */
  int singularUnknown();
}
