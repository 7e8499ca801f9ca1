package org.mechservice.solver.integration;

class DeBreakpointTest extends BreakpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new De(settings);
  }
}
