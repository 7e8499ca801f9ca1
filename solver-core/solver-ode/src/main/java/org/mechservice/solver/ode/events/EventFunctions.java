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
