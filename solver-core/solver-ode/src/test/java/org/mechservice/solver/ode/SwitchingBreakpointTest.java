package org.mechservice.solver.ode;

class SwitchingBreakpointTest extends BreakpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Switching(settings);
  }
}
