package org.mechservice.solver.ode.jumps;

import org.mechservice.solver.ode.CheckpointContract;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.stiff.Ode15sR;

class SearchedOde15sRCheckpointTest extends CheckpointContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return UndeclaredJumps.around(new Ode15sR(settings));
  }
}
