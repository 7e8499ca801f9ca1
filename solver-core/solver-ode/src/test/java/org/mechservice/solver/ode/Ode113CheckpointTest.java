package org.mechservice.solver.ode;

class Ode113CheckpointTest extends CheckpointContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode113(settings);
  }
}
