package org.mechservice.solver.ode.stiff;

import org.mechservice.solver.ode.EventContract;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;

class Ode15sEventTest extends EventContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Ode15s(settings);
  }
}
