package org.mechservice.solver.integration;

class Ode15sREventTest extends EventContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15sR(settings);
  }
}
