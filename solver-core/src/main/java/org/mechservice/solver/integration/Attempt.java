package org.mechservice.solver.integration;

/** What a try of a step came to. */
public enum Attempt {
  /** The step was accepted. */
  PASSED,
  /** The error test failed. */
  TOO_INACCURATE,
  /** The iteration for the solution of an implicit method did not converge fast enough. */
  NOT_CONVERGING,
  /** The matrix of that iteration was singular. */
  SINGULAR_MATRIX,
  /** No state was found that also fits the system's own conditions, its loops for instance. */
  OFF_MANIFOLD,
  /** Something was not finite. */
  NOT_FINITE,
  /** The stop signal was given; the try is taken up again. */
  STOPPED
}
