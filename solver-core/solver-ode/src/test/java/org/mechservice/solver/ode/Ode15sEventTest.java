package org.mechservice.solver.ode;

class Ode15sEventTest extends EventContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15s(settings);
  }
}
