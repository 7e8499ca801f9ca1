package org.mechservice.solver.integration;

class DeEventTest extends EventContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new De(settings);
  }
}
