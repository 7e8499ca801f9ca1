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
  /** Components that follow from others could not be found, or there was no way to the manifold. */
  NOT_COMPLETED,
  /** Something was not finite. */
  NOT_FINITE,
  /** The stop signal was given; the try is taken up again. */
  STOPPED
}
