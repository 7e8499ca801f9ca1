package org.mechservice.solver.ode.adams;

import org.mechservice.solver.ode.BreakpointContract;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;

class Ode113BreakpointTest extends BreakpointContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Ode113(settings);
  }
}
