package org.mechservice.solver.ode.solve;

/** Receives the solution at times that were asked for. */
@FunctionalInterface
public interface OutputHandler {
  /**
   * Receives one state, in the order of integration. At a time at which an event has changed the
   * state it is the changed one.
   *
   * @param t the time asked for
   * @param y state there, length n; an array used again for the next one: copy what is to be kept
   */
  void accept(double t, double[] y);
}
