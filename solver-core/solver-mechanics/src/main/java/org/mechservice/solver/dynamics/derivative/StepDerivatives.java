package org.mechservice.solver.dynamics.derivative;

import org.mechservice.solver.force.applied.ForceJacobian;

/**
 * The derivatives of the residual M a + b − τ − Jᵀ w of a tree by a, v and q, in a form that an
 * implicit step can be solved with. Workspace of one thread.
 */
public interface StepDerivatives {
  /**
   * Evaluates the derivatives for the motion of the last sweeps, without those of forces; {@link
   * #finish} completes them.
   *
   * @param wrench external wrenches, 6 per link, or empty; not modified
   */
  void evaluate(double[] wrench);

  /**
   * Returns the sink for the derivatives of applied forces, for use between {@link #evaluate} and
   * {@link #finish}.
   */
  ForceJacobian forces();

  /**
   * Completes the derivatives by positions for balls whose velocities are given in the axes of the
   * parent, after everything else has been added.
   */
  void finish();

  /** Returns whether all derivatives are finite. */
  boolean isFinite();
}
