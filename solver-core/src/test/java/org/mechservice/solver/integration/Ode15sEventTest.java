package org.mechservice.solver.integration;

class Ode15sEventTest extends EventContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15s(settings);
  }
}
