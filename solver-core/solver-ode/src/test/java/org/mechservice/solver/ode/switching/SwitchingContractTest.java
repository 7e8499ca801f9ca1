package org.mechservice.solver.ode.switching;

import org.mechservice.solver.ode.AdamsContract;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;

/** What every integrator does, and on problems that are not stiff what the Adams methods do. */
class SwitchingContractTest extends AdamsContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Switching(settings);
  }
}
