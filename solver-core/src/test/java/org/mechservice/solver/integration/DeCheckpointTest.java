package org.mechservice.solver.integration;

class DeCheckpointTest extends CheckpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new De(settings);
  }
}
