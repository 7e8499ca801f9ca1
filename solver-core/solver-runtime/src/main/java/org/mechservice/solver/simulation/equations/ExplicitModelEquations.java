package org.mechservice.solver.simulation.equations;

import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.StepResult;

/** The explicit form of a model for an integrator. */
class ExplicitModelEquations extends ModelEquations implements OdeSystem {
  private final ExplicitModel model;

  ExplicitModelEquations(ExplicitModel model) {
    super(model, model.description().stateCount());
    this.model = model;
  }

  @Override
  public StepResult start(Integrator integrator, double t0, double[] y0, double tEnd) {
    return integrator.start(this, t0, y0, tEnd);
  }

  @Override
  public StepResult resume(Integrator integrator, byte[] saved) {
    return integrator.resume(this, saved);
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    note(model.derivative(t, y, yDot), yDot);
  }
}
