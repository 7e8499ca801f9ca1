package org.mechservice.solver.ode.stiff;

import org.mechservice.solver.ode.BreakpointContract;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;

class Ode15sRBreakpointTest extends BreakpointContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Ode15sR(settings);
  }
}
