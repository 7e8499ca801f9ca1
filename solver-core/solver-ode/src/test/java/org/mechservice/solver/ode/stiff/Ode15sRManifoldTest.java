package org.mechservice.solver.ode.stiff;

import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.ManifoldContract;

class Ode15sRManifoldTest extends ManifoldContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Ode15sR(settings);
  }

  /** Low order: two to three times the steps of an Adams method, each with an error of one sign. */
  @Override
  protected double accumulation() {
    return 5000;
  }
}
