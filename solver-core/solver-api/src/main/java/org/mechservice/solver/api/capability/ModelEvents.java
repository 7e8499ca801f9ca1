package org.mechservice.solver.api.capability;

import java.util.List;
import org.mechservice.solver.api.run.RunNotes.Note;

/**
 * The events of a model in a run: zero crossings of functions of time and state, and jumps of its
 * equations at known times. Workspace of one run and thread.
 */
public interface ModelEvents {
  /**
   * Begins a run: finds the jumps at known times.
   *
   * @param from start of the run, s
   * @param to its end, s
   * @return the times at which the equations jump
   */
  List<Double> begin(double from, double to);

  /**
   * Applies the samples at the start of the run to the state.
   *
   * @param t start, s
   * @param y state there, loops closed; further states may be overwritten
   * @return whether there is any
   */
  default boolean begin(double t, double[] y) {
    return false;
  }

  /**
   * Returns the events, in file order, then the samplings, then the jumps of prescribed motions in
   * this run.
   */
  List<Kind> kinds();

  /**
   * Evaluates the functions whose zeros are the events.
   *
   * @param t time, s
   * @param y state [q; v], loops closed; not modified
   * @param g one number per event; overwritten
   */
  void values(double t, double[] y, double[] g);

  /**
   * Applies the changes of the events that have occurred to the state.
   *
   * @param occurred one truth value per event; not modified
   * @param t time, s
   * @param y state before at entry, after at return; loops may be open then
   */
  void change(boolean[] occurred, double t, double[] y);

  /** Returns whether an event sets a component of the state. */
  boolean changes(int event, int component);

  /**
   * Returns the time for evaluations at {@code t}, which may be the time of a jump: a time before
   * the jump until {@link #continueFrom}, afterwards a time after it; otherwise {@code t}.
   */
  double evaluationTime(double t);

  /** Records that the run continues after events at a time. */
  void continueFrom(double t);

  /**
   * Returns the first time after the events that have occurred.
   *
   * @param occurred one truth value per event; not modified
   * @param t time at which they were found, s
   * @return {@code t} for events of the state
   */
  double after(boolean[] occurred, double t);

  /** The solution along a step. */
  interface Path {
    /** Goes to a time within the step; returns false where the loops cannot be closed. */
    boolean moveTo(double t);

    /** Returns the state there, loops closed; valid until the next move, not to be modified. */
    double[] state();
  }

  /** Returns whether steps are searched by {@link #seenUntil}. */
  default boolean watches() {
    return false;
  }

  /**
   * Searches an accepted step for what its ends do not show, and for changes of the form of the
   * equations.
   *
   * @param from where the step begins, s
   * @param to where it ends, s
   * @return where it has to end so that nothing has happened in it unseen, at most {@code to}; NaN
   *     if it may stand
   */
  default double seenUntil(double from, double to, Path path) {
    return Double.NaN;
  }

  /**
   * Moves a state in front of a change of the form of the equations behind it, if there is one
   * within rounding.
   *
   * @param t where the integrator's steps have become too short, s
   * @param y state there, loops closed; not modified
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

  /** Returns the longest first step behind the last end that {@link #seenUntil} has set, s. */
  default double longestFirstStep() {
    return Double.POSITIVE_INFINITY;
  }

  /** Returns notes on what the search of the steps has found and cannot mend. */
  default List<Note> notes() {
    return List.of();
  }

  /** The direction of zero crossings that count. */
  enum Direction {
    /** From below to above. */
    RISING,
    /** From above to below. */
    FALLING,
    /** Both. */
    BOTH
  }

  /** The action at a zero crossing. */
  enum Action {
    /** The run ends there. */
    STOP,
    /** The time becomes a row of the results. */
    RECORD,
    /** Coordinates get new values; the run continues from there. */
    SET,
    /** Held states get new values at a given time; the run continues from there. */
    SAMPLE,
    /** The velocity of a driven joint jumps; other velocities change by the impulse. */
    IMPULSE,
    /** The position of a driven joint jumps; the run ends there as failed. */
    BREAK
  }

  /**
   * An event.
   *
   * @param name name in the model file, of the event or of the driven joint
   * @param direction direction of the crossings that count
   * @param action the action
   */
  record Kind(String name, Direction direction, Action action) {}
}
