package org.mechservice.solver.ode;

class SwitchingEventTest extends EventContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Switching(settings);
  }
}
