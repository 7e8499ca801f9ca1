package org.mechservice.solver.ode.stiff;

import org.mechservice.solver.ode.CheckpointContract;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;

class Ode15sCheckpointTest extends CheckpointContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Ode15s(settings);
  }
}
