package org.mechservice.solver.closure;

import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.closure.model.LinearisedProjectionModel;
import org.mechservice.solver.closure.model.LoopModel;
import org.mechservice.solver.closure.model.PenaltyModel;
import org.mechservice.solver.closure.model.ProjectionModel;
import org.mechservice.solver.closure.model.ResidualPenaltyModel;
import org.mechservice.solver.closure.model.ResidualPenaltyModel.Derivatives;
import org.mechservice.solver.closure.model.ResidualProjectionModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.jumps.UndeclaredJumps;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.stiff.Ode15sR;
import org.mechservice.solver.ode.switching.Switching;
import org.mechservice.solver.simulation.RuntimeSolver;
import org.mechservice.solver.simulation.Simulation;

/** Makes models of loops by the names of formulation and closure. */
final class LoopModels {
  private LoopModels() {}

  /**
   * Returns the model of a mechanism.
   *
   * @param formulation {@code DSR}, {@code RR} or {@code RR-JF}; with closure by projection, or by
   *     penalty if {@code " penalty"} follows
   */
  static LoopModel of(Mechanism mechanism, String formulation, RunSettings settings) {
    ClosedMechanism closed = new ClosedMechanism(mechanism, formulation, settings);
    UserForceSource none = UserForceSource.NONE;
    return switch (formulation) {
      case "DSR" -> new ProjectionModel(closed, none);
      case "RR" -> ResidualProjectionModel.of(closed, none);
      case "RR-JF" -> new LinearisedProjectionModel(closed, none);
      case "RR penalty" ->
          new ResidualPenaltyModel(closed, none, PenaltySettings.DEFAULT, Derivatives.DIFFERENCES);
      case "RR-JF penalty" ->
          new ResidualPenaltyModel(closed, none, PenaltySettings.DEFAULT, Derivatives.RECURSIVE);
      case "DSR penalty" -> new PenaltyModel(closed, none, PenaltySettings.DEFAULT);
      default -> throw new IllegalArgumentException(formulation);
    };
  }

  /** Runs a mechanism as the settings say. */
  static SceneRun run(Mechanism mechanism, String formulation, RunSettings settings) {
    return SceneRun.of(of(mechanism, formulation, settings));
  }

  /** Runs a mechanism with a search for jumps, as if a class of a user computed its forces. */
  static SceneRun runSearched(Mechanism mechanism, String formulation, RunSettings settings) {
    LoopModel model = of(mechanism, formulation, settings);
    String name = settings.integrator();
    return SceneRun.by(
        new Simulation(how -> searched(name, how), RuntimeSolver.formOf(model, name)), model);
  }

  private static Integrator searched(String name, IntegratorSettings how) {
    return UndeclaredJumps.around(
        switch (name) {
          case "ode15s" -> new Ode15s(how);
          case "ode15sR" -> new Ode15sR(how);
          case "switching" -> new Switching(how);
          default -> throw new IllegalArgumentException(name);
        });
  }
}
