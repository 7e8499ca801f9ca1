package org.mechservice.solver.ode.solve;

import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegrationFailure.Cause;

/**
 * An integration that could not go on. It carries the solution up to there; its message says where
 * and why the integration ended and what to try instead.
 */
public final class IntegrationException extends RuntimeException {
  private static final long serialVersionUID = 1;

  private final transient OdeSolution solution;
  private final transient IntegrationFailure failure;

  /** Whether the method takes explicit steps only; the others are not told to use what they are. */
  private final boolean explicit;

  /**
   * @param method that has integrated
   * @param event what to call the event function that was not finite, if that is the failure
   */
  IntegrationException(
      OdeSolution solution,
      IntegrationFailure failure,
      OdeMethod method,
      long maxSteps,
      String event) {
    super(message(solution, failure, isExplicit(method), maxSteps, event));
    explicit = isExplicit(method);
    this.solution = solution;
    this.failure = failure;
  }

  private static boolean isExplicit(OdeMethod method) {
    return method == OdeMethod.ODE113 || method == OdeMethod.DE;
  }

  /** Returns the solution as far as it is known. */
  public OdeSolution solution() {
    return solution;
  }

  /** Returns the failure with its component, tolerance and last steps. */
  public IntegrationFailure failure() {
    return failure;
  }

  /** Returns what kind of failure it is. */
  public Cause reason() {
    return failure.cause();
  }

  /** Returns where the interval begins in which the solution is lost. */
  public double lostFrom() {
    return failure.time();
  }

  /** Returns where that interval ends: the end of the step that was tried last. */
  public double lostTo() {
    return solution.end() + failure.stepSize();
  }

  /** Returns what to try instead. */
  public String advice() {
    return advice(failure.cause(), explicit);
  }

  private static String message(
      OdeSolution solution,
      IntegrationFailure failure,
      boolean explicit,
      long maxSteps,
      String event) {
    StringBuilder text = new StringBuilder();
    text.append("the integration from t = ").append(solution.start());
    text.append(" to ").append(solution.requestedEnd());
    text.append(" ended at t = ").append(solution.end());
    text.append(" (step ").append(failure.stepSize()).append("): ");
    text.append(
        failure.slidesAlongJump()
            ? "the solution slides along a jump of the equations, which both sides lead back to"
            : cause(failure.cause(), maxSteps, event));
    if (failure.worstComponent() >= 0) {
      text.append("; y[").append(failure.worstComponent()).append("] limits it");
    }
    if (failure.time() != solution.end()) {
      text.append("; the solution is lost between t = ").append(failure.time());
      text.append(" and t = ").append(solution.end() + failure.stepSize());
    }
    String advice =
        failure.slidesAlongJump()
            ? "Describe the motion along the jump by equations of its own, entered and left at"
                + " events, or replace the jump by a steep slope"
                + (explicit ? " and use ODE15S or AUTO." : ".")
            : advice(failure.cause(), explicit);
    return text.append(". ").append(advice).toString();
  }

  private static String cause(Cause cause, long maxSteps, String event) {
    return switch (cause) {
      case STEP_TOO_SMALL -> "the error test fails however small the step";
      case UNBOUNDED -> "the solution grows beyond every bound there";
      case TOLERANCE_TOO_TIGHT -> "the tolerance asks for more digits than the arithmetic has";
      case NOT_FINITE ->
          "the equations, or their Jacobian, are not finite there, also with shorter steps";
      case NO_CONVERGENCE -> "the equations of a step cannot be solved, however small it is";
      case SINGULAR_MATRIX -> "the matrix of the equations of a step is singular";
      case NOT_COMPLETED -> "components that follow from others cannot be found";
      case EVENTS_ACCUMULATE -> "events follow each other ever closer";
      case EVENT_NOT_FINITE -> "the function of event " + event + " is not finite in the last step";
      case INCONSISTENT_START -> "no values at the start were found that obey the equations";
      case TOO_MANY_STEPS -> "the " + maxSteps + " steps allowed are used up";
    };
  }

  private static String advice(Cause cause, boolean explicit) {
    return switch (cause) {
      case STEP_TOO_SMALL ->
          "Look at the equations near this place: the solution may end here or jump. Declare jumps"
              + " by withBreakpoints or by an event, or loosen the tolerances.";
      case UNBOUNDED ->
          "Ask for an earlier end, or end the integration before the pole by a terminal event.";
      case TOLERANCE_TOO_TIGHT -> "Loosen rtol or atol.";
      case NOT_FINITE ->
          "Look for a division by zero or a root or logarithm of a negative number in the"
              + " equations, or end the integration before that place by a terminal event.";
      case NO_CONVERGENCE ->
          "Check an analytic Jacobian, a band or a pattern against the equations; declare jumps by"
              + " withBreakpoints or by an event.";
      case SINGULAR_MATRIX ->
          "Check that each unknown is determined by an equation, that the index is at most 1, and"
              + " that a Jacobian, band or pattern belongs to these equations.";
      case NOT_COMPLETED -> "Check the initial state and the part that completes or projects it.";
      case EVENTS_ACCUMULATE ->
          "Make the event terminal after some count, give it a hysteresis, or describe the state"
              + " of rest behind it by other equations.";
      case EVENT_NOT_FINITE -> "Define the event function for every state the solution can reach.";
      case INCONSISTENT_START ->
          "Give initial values nearer to a solution of the equations: only components that are"
              + " declared by withAlgebraic, or whose column of the mass matrix is zero, are"
              + " corrected. Check also that the index is at most 1.";
      case TOO_MANY_STEPS ->
          explicit
              ? "Raise maxSteps, loosen the tolerances, or use AUTO or ODE15S if the problem is"
                  + " stiff."
              : "Raise maxSteps, or loosen the tolerances.";
    };
  }
}
