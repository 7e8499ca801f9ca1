package org.mechservice.solver.ode;

class Ode113EventTest extends EventContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode113(settings);
  }
}
