package org.mechservice.solver.ode.adams;

import org.mechservice.solver.ode.CheckpointContract;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;

class DeCheckpointTest extends CheckpointContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new De(settings);
  }
}
