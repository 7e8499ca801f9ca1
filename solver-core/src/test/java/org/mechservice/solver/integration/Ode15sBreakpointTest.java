package org.mechservice.solver.integration;

class Ode15sBreakpointTest extends BreakpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15s(settings);
  }

  /** Errors of one sign per step, at low order: the end has up to 2.6 digits fewer than asked. */
  @Override
  IntegratorSettings settingsFor(double tolerance) {
    return new IntegratorSettings(0.01 * tolerance, 0.01 * tolerance);
  }
}
