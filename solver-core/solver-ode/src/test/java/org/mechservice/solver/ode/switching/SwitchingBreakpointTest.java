package org.mechservice.solver.ode.switching;

import org.mechservice.solver.ode.BreakpointContract;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;

class SwitchingBreakpointTest extends BreakpointContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Switching(settings);
  }
}
