package org.mechservice.solver.ode;

class Ode113ManifoldTest extends ManifoldContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode113(settings);
  }
}
