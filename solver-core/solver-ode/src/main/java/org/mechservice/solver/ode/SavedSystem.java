package org.mechservice.solver.ode;

/**
 * A problem, or its event functions, with a state of its own that an integration depends on, such
 * as the choice of independent coordinates or a contact that is closed. Implemented beside {@link
 * OdeSystem}, {@link ResidualSystem} or {@code EventFunctions}, so that it is saved and taken up
 * with the integration.
 */
public interface SavedSystem {
  /** Carries the state over, to bytes or back from them. */
  void transfer(SavedState state);
}
