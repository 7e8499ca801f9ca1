package org.mechservice.solver.dynamics;

import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.mechanism.Mechanism;

/** A generated residual (RR) combined with user force classes. */
class UserForcedResidualModel extends UserForcedModel implements ResidualModel {
  private final ResidualModel generated;

  UserForcedResidualModel(ResidualModel generated, Mechanism mechanism, UserLoads loads) {
    super(generated, mechanism, loads);
    this.generated = generated;
  }

  @Override
  public final int residual(double t, double[] y, double[] yDot, double[] residual) {
    int loaded = loads.evaluate(t, y);
    return loaded == REGULAR ? generated.residual(t, y, yDot, residual) : loaded;
  }
}
