package org.mechservice.solver.api;

import java.util.List;

/**
 * What happens along a run of a model: where functions of time and state pass through zero, and
 * where its equations jump at known times. Workspace of one run and thread.
 */
public interface ModelEvents {
  /** Returns the events, in file order. */
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
   * Returns the times at which the equations jump.
   *
   * @param from first time of interest, s
   * @param to last one, s
   */
  List<Double> jumps(double from, double to);

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
    SET
  }

  /**
   * An event.
   *
   * @param name name in the model file
   * @param direction which passages count
   * @param action what happens
   */
  record Kind(String name, Direction direction, Action action) {}
}
