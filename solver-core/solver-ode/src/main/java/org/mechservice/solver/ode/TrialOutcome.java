package org.mechservice.solver.ode;

import org.mechservice.solver.ode.IntegrationFailure.Cause;

/** The outcome of a trial step. */
public enum TrialOutcome {
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
  /** A value was not finite. */
  NOT_FINITE,
  /** The stop signal was given; the try is taken up again. */
  STOPPED;

  /** Returns what to call it, where nothing more is known, when no smaller step is left. */
  public Cause cause() {
    return switch (this) {
      case NOT_FINITE -> Cause.NOT_FINITE;
      case NOT_COMPLETED -> Cause.NOT_COMPLETED;
      case NOT_CONVERGING -> Cause.NO_CONVERGENCE;
      case SINGULAR_MATRIX -> Cause.SINGULAR_MATRIX;
      default -> Cause.STEP_TOO_SMALL;
    };
  }
}
