package org.mechservice.solver.compact;

import java.util.Optional;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.dynamics.LinearisedResidualModel;
import org.mechservice.solver.dynamics.RecursiveResidualModel;
import org.mechservice.solver.dynamics.SemiRecursiveModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;

/** The data-driven formulations of open chains, apart from those of loops. */
public final class DataDrivenTree {
  private DataDrivenTree() {}

  /**
   * Returns the equations of motion of a model's data, with its events.
   *
   * @param userForces creates the user forces
   * @throws IllegalArgumentException if there is no such formulation
   */
  public static Model model(CompactModel data, UserForceSource userForces) {
    return data.watched(equations(data, userForces), Optional.empty());
  }

  private static Model equations(CompactModel data, UserForceSource userForces) {
    Mechanism mechanism = data.mechanism();
    RunSettings settings = data.settings();
    return switch (data.knownFormulation()) {
      case DTR -> new DataDrivenModel(mechanism, settings, userForces);
      case DSR -> new SemiRecursiveModel(mechanism, settings, userForces);
      case RR -> new RecursiveResidualModel(mechanism, settings, userForces);
      case RR_JF ->
          new LinearisedResidualModel(
              mechanism, settings, userForces, LinearisedResidualModel.Mode.FULL);
    };
  }
}
