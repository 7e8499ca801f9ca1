package org.mechservice.solver.ode;

class DeEventTest extends EventContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new De(settings);
  }
}
