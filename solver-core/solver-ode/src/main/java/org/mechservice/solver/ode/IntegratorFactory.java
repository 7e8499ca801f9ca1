package org.mechservice.solver.ode;

/** Makes integrators of one kind. */
public interface IntegratorFactory {
  /**
   * Returns a new integrator.
   *
   * @throws IllegalArgumentException if a setting is out of range
   */
  Integrator create(IntegratorSettings settings);
}
