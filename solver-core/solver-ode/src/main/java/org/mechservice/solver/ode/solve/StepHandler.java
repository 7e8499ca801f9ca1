package org.mechservice.solver.ode.solve;

/** Receives each accepted step while the integration goes on. */
@FunctionalInterface
public interface StepHandler {
  /**
   * Receives a step, in the order of integration. A step that an event has ended reaches to the
   * event.
   *
   * @param step valid during the call only
   */
  void accept(SolvedStep step);
}
