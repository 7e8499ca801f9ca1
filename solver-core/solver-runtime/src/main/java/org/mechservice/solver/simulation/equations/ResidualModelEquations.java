package org.mechservice.solver.simulation.equations;

import java.util.Optional;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.ResidualIntegrator;
import org.mechservice.solver.ode.ResidualSystem;
import org.mechservice.solver.ode.StepResult;

/** The residual form of a model for an integrator. */
class ResidualModelEquations extends ModelEquations implements ResidualSystem {
  private final ResidualModel model;

  /** Unknown whose derivative at the start is not finite, or −1. */
  private int startNotFinite = -1;

  ResidualModelEquations(ResidualModel model) {
    super(model, model.unknownCount());
    this.model = model;
  }

  @Override
  public StepResult start(Integrator integrator, double t0, double[] y0, double tEnd) {
    ResidualIntegrator method = residual(integrator);
    double[] yDot0 = new double[dimension()];
    int result = model.consistent(t0, y0, yDot0);
    note(result, yDot0);
    startNotFinite = firstNotFinite(yDot0);
    return startNotFinite < 0 && result == ExplicitModel.REGULAR
        ? method.start(this, t0, y0, yDot0, tEnd)
        : StepResult.FAILED;
  }

  private static int firstNotFinite(double[] values) {
    for (int i = 0; i < values.length; i++) {
      if (!Double.isFinite(values[i])) {
        return i;
      }
    }
    return -1;
  }

  @Override
  public Optional<Defects.Defect> defect() {
    Optional<Defects.Defect> ofModel = super.defect();
    return ofModel.isPresent() || startNotFinite < 0 || singularJoint() != ExplicitModel.REGULAR
        ? ofModel
        : Optional.of(
            new Defects.Defect(
                MessageCode.NOT_FINITE,
                name(startNotFinite),
                "The accelerations are not finite.",
                "Check masses, inertias and forces for values that are zero, huge or opposite."));
  }

  @Override
  public StepResult resume(Integrator integrator, byte[] saved) {
    return residual(integrator).resume(this, saved);
  }

  private static ResidualIntegrator residual(Integrator integrator) {
    if (integrator instanceof ResidualIntegrator method) {
      return method;
    }
    throw new IllegalArgumentException(
        MessageCode.EQUATION_FORM_MISSING
            + " the integrator takes no residual form F(t, y, y') = 0");
  }

  @Override
  public void residual(double t, double[] y, double[] yDot, double[] residual) {
    note(model.residual(t, y, yDot, residual), residual);
  }

  @Override
  public boolean massMatrixMoves() {
    return true;
  }

  @Override
  public Component component(int index) {
    return model.isDifferential(index) ? Component.DIFFERENTIAL : Component.ALGEBRAIC;
  }
}
