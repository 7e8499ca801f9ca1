package org.mechservice.solver.ode;

class Ode113BreakpointTest extends BreakpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode113(settings);
  }
}
