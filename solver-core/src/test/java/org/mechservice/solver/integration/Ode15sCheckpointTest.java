package org.mechservice.solver.integration;

class Ode15sCheckpointTest extends CheckpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15s(settings);
  }
}
