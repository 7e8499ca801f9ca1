package org.mechservice.solver.ode.stiff;

import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorContract;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.backward.BackwardFormulas;

/** ode15s with backward differentiation formulas does what every integrator does. */
class BackwardDifferentiationTest extends IntegratorContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Ode15s(settings, BackwardFormulas.BDF);
  }

  /** Two to three digits: an error per step of low order, made many times. */
  @Override
  protected double accumulation() {
    return 1000;
  }

  @Override
  protected double notFiniteReduction() {
    return 0.3;
  }
}
