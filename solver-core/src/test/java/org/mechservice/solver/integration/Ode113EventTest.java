package org.mechservice.solver.integration;

class Ode113EventTest extends EventContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode113(settings);
  }
}
