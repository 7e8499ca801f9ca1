package org.mechservice.solver.closure;

import org.mechservice.solver.api.capability.ModelParts;
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
    return SceneRun.of(ModelParts.of(of(mechanism, formulation, settings)).withUserClasses());
  }
}
