package org.mechservice.solver.ode;

class SwitchingManifoldTest extends ManifoldContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Switching(settings);
  }
}
