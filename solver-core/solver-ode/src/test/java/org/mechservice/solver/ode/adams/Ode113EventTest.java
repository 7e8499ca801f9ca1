package org.mechservice.solver.ode.adams;

import org.mechservice.solver.ode.EventContract;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;

class Ode113EventTest extends EventContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Ode113(settings);
  }
}
