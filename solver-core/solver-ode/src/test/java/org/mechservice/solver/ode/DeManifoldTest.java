package org.mechservice.solver.ode;

class DeManifoldTest extends ManifoldContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new De(settings);
  }
}
