package org.mechservice.solver.ode;

class DeCheckpointTest extends CheckpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new De(settings);
  }
}
