package org.mechservice.solver.integration;

class DeManifoldTest extends ManifoldContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new De(settings);
  }
}
