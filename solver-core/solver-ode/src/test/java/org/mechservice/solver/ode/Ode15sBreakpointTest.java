package org.mechservice.solver.ode;

class Ode15sBreakpointTest extends BreakpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15s(settings);
  }
}
