package org.mechservice.solver.integration;

/** How closely ode15s and ode15sR keep to the published rules of step, order and iteration. */
public enum BackwardMode {
  /** To the letter: for comparison with counts of other programs. */
  FAITHFUL,
  /**
   * To the letter, except that systems with algebraic components are held to a third of the
   * tolerances: what leaves them out of the tests costs a digit or half of one, and this gives it
   * back.
   */
  STANDARD,
  /**
   * With rules that save evaluations, factorisations and, near the imaginary axis, steps; as
   * accurate as {@link #STANDARD}.
   */
  TUNED
}
