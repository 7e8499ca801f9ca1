package org.mechservice.solver.dynamics.event;

/**
 * Values of the expressions of a model file that are not part of the equations of motion: triggers
 * of events, values that events assign, and outputs. Generated code implements this interface.
 * Workspace of one thread.
 */
public interface WrittenValues {
  /**
   * Writes the triggers of the events.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   * @param values one number per event, in file order; overwritten
   */
  void triggers(double t, double[] y, double[] values);

  /**
   * Writes the values that the events assign when they occur.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   * @param values one number per component of the state an event sets, in the order of {@link
   *     StateEvents#assigned}; overwritten
   */
  void assignments(double t, double[] y, double[] values);

  /**
   * Writes the quantities from which it is decided what happens inside a step.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   * @param values one number per quantity of {@link WatchedTape#quantities}; overwritten
   */
  void watched(double t, double[] y, double[] values);

  /**
   * Writes the outputs.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   * @param values one number per output, in file order; overwritten
   */
  void outputs(double t, double[] y, double[] values);
}
