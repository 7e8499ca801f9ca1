package org.mechservice.solver.integration;

class Ode113CheckpointTest extends CheckpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode113(settings);
  }
}
