package org.mechservice.solver.ode;

class Ode15sREventTest extends EventContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15sR(settings);
  }
}
