package org.mechservice.solver.ode.adams;

import org.mechservice.solver.ode.EventContract;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;

class DeEventTest extends EventContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new De(settings);
  }
}
