package org.mechservice.solver.integration;

class Ode15sRBreakpointTest extends BreakpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15sR(settings);
  }

  /** Errors of one sign per step, at low order: the end has two to three digits fewer. */
  @Override
  IntegratorSettings settingsFor(double tolerance) {
    return new IntegratorSettings(0.01 * tolerance, 0.01 * tolerance);
  }
}
