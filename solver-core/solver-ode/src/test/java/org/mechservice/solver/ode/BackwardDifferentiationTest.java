package org.mechservice.solver.ode;

/** ode15s with backward differentiation formulas does what every integrator does. */
class BackwardDifferentiationTest extends IntegratorContract {
  @Override
  Integrator create(IntegratorSettings settings) {
    return new Ode15s(settings, BackwardFormulas.BDF);
  }

  /** Two to three digits: an error per step of low order, made many times. */
  @Override
  double accumulation() {
    return 1000;
  }

  @Override
  double notFiniteReduction() {
    return 0.3;
  }
}
