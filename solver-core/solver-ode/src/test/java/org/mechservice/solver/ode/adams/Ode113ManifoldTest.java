package org.mechservice.solver.ode.adams;

import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.ManifoldContract;

class Ode113ManifoldTest extends ManifoldContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Ode113(settings);
  }
}
