package org.mechservice.solver.ode.switching;

import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.ManifoldContract;

class SwitchingManifoldTest extends ManifoldContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Switching(settings);
  }
}
