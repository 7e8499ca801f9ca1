package org.mechservice.solver.integration;

class Ode15sREventTest extends EventContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15sR(settings);
  }

  /** The first steps of a fall, at order 1, err by one tolerance of the height, 10 m. */
  @Override
  double toleranceOfBounces() {
    return 5e-11;
  }
}
