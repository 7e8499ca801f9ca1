package org.mechservice.solver.api.capability;

import java.util.List;

/**
 * What happens along a run of a model: where functions of time and state pass through zero, and
 * where its equations jump at known times. Workspace of one run and thread.
 */
public interface ModelEvents {
  /**
   * Begins a run: looks for what happens at known times.
   *
   * @param from begin of the run, s
   * @param to its end, s
   * @return the times at which the equations jump
   */
  List<Double> begin(double from, double to);

  /** Returns the events, in file order, then the jumps of prescribed motions in the run begun. */
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
   * Changes the state as those events ask that have occurred.
   *
   * @param occurred one truth value per event; not modified
   * @param t time, s
   * @param y state before at entry, after at return; loops may be open then
   */
  void change(boolean[] occurred, double t, double[] y);

  /** Returns whether an event that occurs sets a component of the state. */
  boolean changes(int event, int component);

  /**
   * Returns where to evaluate instead of at {@code t}, which may be the very time at which a motion
   * jumps: before it until {@link #goOn}, then behind it.
   */
  double beside(double t);

  /** Notes that the run goes on from events at a time. */
  void goOn(double t);

  /**
   * Returns the first time behind the events that have occurred.
   *
   * @param occurred one truth value per event; not modified
   * @param t time at which they were found, s
   * @return {@code t} for events of the state
   */
  double after(boolean[] occurred, double t);

  /** Which passages through zero count. */
  enum Direction {
    /** From below to above. */
    RISING,
    /** From above to below. */
    FALLING,
    /** Both. */
    BOTH
  }

  /** What happens at a passage. */
  enum Action {
    /** The run ends there. */
    STOP,
    /** The instant becomes a row of the results. */
    RECORD,
    /** Coordinates take new values; the run goes on from there. */
    SET,
    /** The velocity of a driven joint jumps; others take their part of the impulse. */
    IMPULSE,
    /** The position of a driven joint jumps; the run ends there as failed. */
    BREAK
  }

  /**
   * An event.
   *
   * @param name name in the model file, of the event or of the driven joint
   * @param direction which passages count
   * @param action what happens
   */
  record Kind(String name, Direction direction, Action action) {}
}
