package org.mechservice.solver.ode.adams;

import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.ManifoldContract;

class DeManifoldTest extends ManifoldContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new De(settings);
  }
}
