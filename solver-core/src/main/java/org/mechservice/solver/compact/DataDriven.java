package org.mechservice.solver.compact;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.ProjectionModel;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.force.UserForceSource;

/** Takes the data-driven formulation that a compact model names. */
final class DataDriven {
  private DataDriven() {}

  static Model model(CompactModel model, UserForceSource userForces) {
    if (model.closure().equals("projection")) {
      return new ProjectionModel(
          new ClosedMechanism(model.mechanism(), model.formulation(), model.settings()),
          userForces);
    }
    return new DataDrivenModel(model.mechanism(), model.settings());
  }
}
