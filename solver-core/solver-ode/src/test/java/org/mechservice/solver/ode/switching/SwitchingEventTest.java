package org.mechservice.solver.ode.switching;

import org.mechservice.solver.ode.EventContract;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;

class SwitchingEventTest extends EventContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Switching(settings);
  }
}
