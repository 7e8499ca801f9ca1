package org.mechservice.solver.ode;

/** What every integrator does, and on problems that are not stiff what the Adams methods do. */
class SwitchingContractTest extends AdamsContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Switching(settings);
  }
}
