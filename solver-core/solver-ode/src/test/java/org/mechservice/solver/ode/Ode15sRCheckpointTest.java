package org.mechservice.solver.ode;

class Ode15sRCheckpointTest extends CheckpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15sR(settings);
  }
}
