package org.mechservice.solver.dynamics.event;

/**
 * The expressions of a model's author that are no part of its equations, as code written for them:
 * what its events watch, what they assign, and its outputs. Workspace of one thread.
 */
public interface WrittenValues {
  /**
   * Writes what the events watch.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   * @param values one number per event, in file order; overwritten
   */
  void triggers(double t, double[] y, double[] values);

  /**
   * Writes what the events assign when they occur.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   * @param values one number per component of the state an event sets, in the order of {@link
   *     StateEvents#assigned}; overwritten
   */
  void assignments(double t, double[] y, double[] values);

  /**
   * Writes the outputs.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   * @param values one number per output, in file order; overwritten
   */
  void outputs(double t, double[] y, double[] values);
}
