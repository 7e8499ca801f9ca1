package org.mechservice.solver.integration;

class Ode15sBreakpointTest extends BreakpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15s(settings);
  }
}
