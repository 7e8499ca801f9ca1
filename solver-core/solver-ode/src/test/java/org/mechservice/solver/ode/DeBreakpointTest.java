package org.mechservice.solver.ode;

class DeBreakpointTest extends BreakpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new De(settings);
  }
}
