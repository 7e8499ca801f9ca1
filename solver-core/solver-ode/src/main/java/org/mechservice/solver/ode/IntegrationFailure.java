package org.mechservice.solver.ode;

import java.util.List;

/**
 * The reason why an integration could not continue.
 *
 * @param cause what kind of failure
 * @param time where it stands; if the step became too small, where steps were last longer than the
 *     relative tolerance times the time elapsed: the solution moves so fast beyond that place that
 *     the one computed is not where the exact one is, and the failure lies between there and the
 *     end of the step tried last
 * @param stepSize step tried last, signed; 0 at the start
 * @param order order tried last; 0 at the start
 * @param worstComponent index of the component that limited the step, was not finite, or left no
 *     pivot in the matrix; −1 if none can be named
 * @param allowedError error per step that the tolerances allow in that component; 0 if none is
 *     named
 * @param lastSteps the last accepted and rejected steps, oldest first, at most ten
 */
public record IntegrationFailure(
    Cause cause,
    double time,
    double stepSize,
    int order,
    int worstComponent,
    double allowedError,
    List<StepRecord> lastSteps) {

  public IntegrationFailure {
    lastSteps = List.copyOf(lastSteps);
  }

  /**
   * Returns whether the steps became too small for what is left, and not for the arithmetic: the
   * solution slides along a jump of the right-hand side, of which both sides lead back to it, and
   * would cross it millions of times.
   */
  public boolean slidesAlongJump() {
    double spacing = Math.ulp(Math.abs(time) + Math.abs(stepSize));
    return cause == Cause.STEP_TOO_SMALL && Math.abs(stepSize) > 1000 * spacing;
  }

  /** Kinds of failure. */
  public enum Cause {
    /**
     * The error test fails at the smallest step the arithmetic can hold, or the solution
     * {@linkplain #slidesAlongJump slides along a jump}.
     */
    STEP_TOO_SMALL,
    /**
     * The right-hand side and the solution grow beyond every bound within the next step: a pole.
     */
    UNBOUNDED,
    /** The tolerance asks for more digits than the arithmetic has. */
    TOLERANCE_TOO_TIGHT,
    /** The right-hand side is not finite, also after the step was reduced repeatedly. */
    NOT_FINITE,
    /** The iteration of an implicit method does not converge, however small the step. */
    NO_CONVERGENCE,
    /** The matrix of that iteration is singular to working precision, however small the step. */
    SINGULAR_MATRIX,
    /**
     * The components that follow from others cannot be found, or there is no way to the manifold of
     * the solution, however small the step.
     */
    NOT_COMPLETED,
    /** Events follow each other ever closer, or no farther apart than round-off. */
    EVENTS_ACCUMULATE,
    /**
     * An event function is not finite, or the state at which to evaluate it cannot be completed.
     */
    EVENT_NOT_FINITE,
    /**
     * No consistent initial values were found for a system in residual form; the component is the
     * row of the residual that is worst.
     */
    INCONSISTENT_START,
    /** The number of steps allowed is used up. */
    TOO_MANY_STEPS
  }

  /**
   * One step that was tried.
   *
   * @param time where it started
   * @param stepSize signed
   * @param order order used
   * @param error estimated local error over the tolerance; accepted if at most 1; NaN if the try
   *     did not get as far as an estimate
   * @param attempt what became of it
   */
  public record StepRecord(
      double time, double stepSize, int order, double error, TrialOutcome attempt) {}
}
