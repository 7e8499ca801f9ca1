package org.mechservice.solver.ode;

/** The outcome of a step. */
public enum StepResult {
  /** A step was accepted; the end of the problem lies further on. */
  ADVANCED,
  /** A step was accepted and the end of the problem is reached. */
  REACHED_END,
  /** No step could be accepted; {@link Integrator#failure()} says why. */
  FAILED,
  /** The stop signal was given; the state is that of the last accepted step. */
  STOPPED
}
