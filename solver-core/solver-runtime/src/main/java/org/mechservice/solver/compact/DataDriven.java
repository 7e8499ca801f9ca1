package org.mechservice.solver.compact;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.PenaltySettings;
import org.mechservice.solver.closure.equations.LoopTerms;
import org.mechservice.solver.closure.model.LinearisedProjectionModel;
import org.mechservice.solver.closure.model.PenaltyModel;
import org.mechservice.solver.closure.model.ProjectionModel;
import org.mechservice.solver.closure.model.ResidualPenaltyModel;
import org.mechservice.solver.closure.model.ResidualPenaltyModel.Derivatives;
import org.mechservice.solver.closure.model.ResidualProjectionModel;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.dynamics.LinearisedResidualModel;
import org.mechservice.solver.dynamics.RecursiveResidualModel;
import org.mechservice.solver.dynamics.SemiRecursiveModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;

/** Selects the data-driven formulation that a compact model names. */
final class DataDriven {
  private DataDriven() {}

  /**
   * @throws IllegalArgumentException if there is no such formulation, or it does not fit
   */
  static Model model(CompactModel model, UserForceSource userForces) {
    Mechanism mechanism = model.mechanism();
    RunSettings settings = model.settings();
    return mechanism.closures().isEmpty()
        ? open(model.formulation(), mechanism, settings, userForces)
        : closed(closed(model), model, userForces);
  }

  /** Returns a model of a mechanism with loops whose terms generated code evaluates. */
  static Model coded(CompactModel model, UserForceSource userForces, LoopTerms code) {
    return closed(closed(model).evaluatedBy(code), model, userForces);
  }

  private static ClosedMechanism closed(CompactModel model) {
    return new ClosedMechanism(model.mechanism(), model.formulation(), model.settings());
  }

  private static Model open(
      String formulation, Mechanism mechanism, RunSettings settings, UserForceSource userForces) {
    return switch (known(formulation)) {
      case DTR -> new DataDrivenModel(mechanism, settings, userForces);
      case DSR -> new SemiRecursiveModel(mechanism, settings, userForces);
      case RR -> new RecursiveResidualModel(mechanism, settings, userForces);
      case RR_JF ->
          new LinearisedResidualModel(
              mechanism, settings, userForces, LinearisedResidualModel.Mode.FULL);
    };
  }

  private static Model closed(
      ClosedMechanism closed, CompactModel model, UserForceSource userForces) {
    return PenaltySettings.isPenalty(model.closure())
        ? byPenalty(closed, model, userForces)
        : byProjection(closed, model.formulation(), userForces);
  }

  private static Model byPenalty(
      ClosedMechanism closed, CompactModel model, UserForceSource userForces) {
    PenaltySettings settings = PenaltySettings.of(model.closure());
    return switch (known(model.formulation())) {
      case DSR -> new PenaltyModel(closed, userForces, settings);
      case RR -> new ResidualPenaltyModel(closed, userForces, settings, Derivatives.DIFFERENCES);
      case RR_JF -> new ResidualPenaltyModel(closed, userForces, settings, Derivatives.RECURSIVE);
      case DTR -> throw unknown(model.formulation());
    };
  }

  private static Model byProjection(
      ClosedMechanism closed, String formulation, UserForceSource userForces) {
    return switch (known(formulation)) {
      case DSR -> new ProjectionModel(closed, userForces);
      case RR -> new ResidualProjectionModel(closed, userForces);
      case RR_JF -> new LinearisedProjectionModel(closed, userForces);
      case DTR -> throw unknown(formulation);
    };
  }

  private static Formulation known(String formulation) {
    return Formulation.find(formulation).orElseThrow(() -> unknown(formulation));
  }

  private static IllegalArgumentException unknown(String formulation) {
    return new IllegalArgumentException(
        MessageCode.MODEL_DATA_DAMAGED
            + " the model is written in a formulation this solver does not have: "
            + formulation);
  }
}
