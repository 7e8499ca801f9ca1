package org.mechservice.solver.ode;

class Ode15sRManifoldTest extends ManifoldContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15sR(settings);
  }

  /** Low order: two to three times the steps of an Adams method, each with an error of one sign. */
  @Override
  double accumulation() {
    return 5000;
  }
}
