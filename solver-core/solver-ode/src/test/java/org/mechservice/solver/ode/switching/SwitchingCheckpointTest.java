package org.mechservice.solver.ode.switching;

import org.mechservice.solver.ode.CheckpointContract;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;

class SwitchingCheckpointTest extends CheckpointContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Switching(settings);
  }
}
