package org.mechservice.solver.integration;

/** Makes integrators of one kind. */
public interface IntegratorFactory {
  /**
   * Returns a new integrator.
   *
   * @throws IllegalArgumentException if a setting is out of range
   */
  Integrator create(IntegratorSettings settings);
}
