package org.mechservice.solver.ode;

class SwitchingCheckpointTest extends CheckpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Switching(settings);
  }
}
