package org.mechservice.solver.integration;

class Ode15sRCheckpointTest extends CheckpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15sR(settings);
  }
}
