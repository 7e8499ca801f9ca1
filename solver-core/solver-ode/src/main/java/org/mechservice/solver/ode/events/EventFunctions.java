package org.mechservice.solver.ode.events;

import org.mechservice.solver.ode.CompletedSystem;

/**
 * Functions g_i(t, y) of a solution whose changes of sign are events, and what is to happen at
 * them. See {@link EventIntegration}.
 */
public interface EventFunctions {
  /** Returns the number of functions. */
  int count();

  /**
   * Evaluates all functions; they should be continuous in t along a solution.
   *
   * @param t where
   * @param y state, completed if the problem is a {@link CompletedSystem}; not modified
   * @param g length {@link #count()}; overwritten
   */
  void evaluate(double t, double[] y, double[] g);

  /** Returns which changes of sign of a function are events. */
  default Direction direction(int function) {
    return Direction.EITHER;
  }

  /**
   * Returns how far from 0 a function must have been since its last event before its next change of
   * sign is one; 0: just beyond the uncertainty of its zeros. A change of sign nearer to 0 becomes
   * an event when the function gets this far on the other side.
   */
  default double hysteresis(int function) {
    return 0;
  }

  /**
   * Reacts to an event.
   *
   * @param t just behind it
   * @param y state there, completed; may be overwritten if the reaction is a restart
   * @param occurred which functions have changed sign, length {@link #count()}; more than one if
   *     their zeros cannot be told apart; not modified, and valid during the call only
   */
  Reaction occurred(double t, double[] y, boolean[] occurred);

  /**
   * Returns how near to 0 a function that turns back counts as touching it, relative to its largest
   * value so far: the accuracy of the solution, below which nobody knows whether 0 was passed.
   */
  default double resolution() {
    return Math.sqrt(Math.ulp(1.0));
  }

  /**
   * Notes a place at which a function has no event though it is there at zero, beyond it, or
   * changes its sign.
   *
   * @param why which of these
   * @param t where
   * @param value of the function there, or beside it
   */
  default void noEvent(int function, NoEvent why, double t, double value) {}

  /** Notes that the integration goes on from a place at which the reaction was a restart. */
  default void restarting(double t) {}

  /** The solution along the last step. */
  interface Path {
    /** Goes to a place within the step; returns false where the state cannot be completed. */
    boolean moveTo(double t);

    /** Returns the state there, completed; valid until the next move, not to be modified. */
    double[] state();
  }

  /** Returns whether steps are searched by {@link #seenUntil}. */
  default boolean searchesSteps() {
    return false;
  }

  /**
   * Searches an accepted step for what the error test cannot have seen, by knowledge of the
   * equations that the integrator does not have.
   *
   * @param from where the step begins
   * @param to where it ends
   * @param path the interpolated solution between
   * @return where the step has to end so that nothing has happened in it unseen, behind {@code
   *     from} and at most at {@code to}: the integration begins anew from there. NaN if the step
   *     may stand
   */
  default double seenUntil(double from, double to, Path path) {
    return Double.NaN;
  }

  /**
   * Moves a state in front of a change of the equations behind it, if there is one within rounding:
   * no step across a jump passes the error test where the tolerance is finer than the jump times
   * the shortest step.
   *
   * @param t where steps have become too short
   * @param y state there; not modified
   * @param yDot its derivative; not modified
   * @param behind the state moved along its derivative by some roundings of t; overwritten
   * @return whether there is such a change
   */
  default boolean moveAcross(double t, double[] y, double[] yDot, double[] behind) {
    return false;
  }

  /**
   * Returns since when all of some thousand steps, the last of them searched last, have stayed at
   * one jump of the equations; NaN if there is no such row of steps.
   */
  default double slidingSince() {
    return Double.NaN;
  }

  /** Returns the longest first step behind the last end that {@link #seenUntil} has set. */
  default double longestFirstStep() {
    return Double.POSITIVE_INFINITY;
  }

  /** Changes of sign. */
  enum Direction {
    /** From negative to positive. */
    RISING,
    /** From positive to negative. */
    FALLING,
    /** Both. */
    EITHER
  }

  /** Why a function has no event at a place. */
  enum NoEvent {
    /**
     * It was exactly 0 at the start and has left 0 at once in a direction that counts: nothing says
     * on which side it was before.
     */
    ZERO_AT_START,
    /** At the start it is on the side that its events lead to. */
    PASSED_AT_START,
    /** It comes to 0 and turns back without a change of sign. */
    TOUCH,
    /** It changes its sign through infinity. */
    POLE
  }

  /** The reaction to an event. */
  enum Reaction {
    /** Nothing: the event was only looked for. */
    CONTINUE,
    /** The state or the equations have changed: the integration begins anew from there. */
    RESTART,
    /** The integration ends here. */
    STOP
  }
}
