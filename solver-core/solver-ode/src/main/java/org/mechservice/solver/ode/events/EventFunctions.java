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
   * Notes that a function was exactly 0 at the start and has left 0 in a direction that counts.
   * That is no event, as nothing says on which side it was before.
   */
  default void leftZeroAtStart(int function) {}

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
   * @return where the step has to end so that nothing has happened in it unseen: behind {@code
   *     from}, and {@code to} if it may stand. The integration begins anew from there
   */
  default double seenUntil(double from, double to, Path path) {
    return to;
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
