package org.mechservice.solver.integration;

class SwitchingEventTest extends EventContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Switching(settings);
  }
}
