package org.mechservice.solver.integration;

class Ode15sREventTest extends EventContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15sR(settings);
  }

  /** Errors of one sign per step, at low order: the end has two to three digits fewer. */
  @Override
  IntegratorSettings.Mode mode() {
    return IntegratorSettings.Mode.ACCURATE;
  }
}
