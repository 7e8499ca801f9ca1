package org.mechservice.solver.ode;

class Ode15sRBreakpointTest extends BreakpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15sR(settings);
  }
}
