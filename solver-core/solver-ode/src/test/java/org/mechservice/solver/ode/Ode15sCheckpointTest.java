package org.mechservice.solver.ode;

class Ode15sCheckpointTest extends CheckpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15s(settings);
  }
}
