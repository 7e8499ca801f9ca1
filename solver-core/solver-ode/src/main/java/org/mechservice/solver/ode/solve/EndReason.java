package org.mechservice.solver.ode.solve;

/** The reason for the end of an integration. */
public enum EndReason {
  /** The end asked for is reached. */
  REACHED_END,
  /** A terminal event has happened. */
  EVENT,
  /** A step handler has asked to stop. */
  STOPPED,
  /** The cancel signal was given. */
  CANCELLED,
  /** The integration could not go on; {@link OdeSolution#failure} says why. */
  FAILED
}
