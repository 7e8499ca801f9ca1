package org.mechservice.solver.compact;

import java.util.Optional;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.PenaltySettings;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.closure.equations.LoopTerms;
import org.mechservice.solver.closure.model.LinearisedProjectionModel;
import org.mechservice.solver.closure.model.PenaltyModel;
import org.mechservice.solver.closure.model.ProjectionModel;
import org.mechservice.solver.closure.model.ResidualPenaltyModel;
import org.mechservice.solver.closure.model.ResidualPenaltyModel.Derivatives;
import org.mechservice.solver.closure.model.ResidualProjectionModel;
import org.mechservice.solver.dynamics.event.WrittenValues;
import org.mechservice.solver.force.user.UserForceSource;

/** The formulations of mechanisms with loops, whose terms come from data or generated code. */
public final class DataDrivenLoops {
  private DataDrivenLoops() {}

  /**
   * Returns the equations of motion of a model's data, with its events.
   *
   * @param userForces creates the user forces
   * @throws IllegalArgumentException if the formulation or the closure does not fit the mechanism
   */
  public static Model model(CompactModel data, UserForceSource userForces) {
    return data.watched(equations(closed(data), data, userForces), Optional.empty());
  }

  /**
   * Returns the equations of motion with terms evaluated by generated code.
   *
   * @param userForces creates the user forces
   * @param code code of the terms, for this model only
   * @param values as for {@link CompactModel#watched}
   */
  public static Model model(
      CompactModel data,
      UserForceSource userForces,
      LoopTerms code,
      Optional<WrittenValues> values) {
    return data.watched(equations(closed(data).evaluatedBy(code), data, userForces), values);
  }

  private static ClosedMechanism closed(CompactModel data) {
    ClosedStart start =
        data.start()
            .map(found -> new ClosedStart(data.mechanism(), (ClosedStart.Found) found))
            .orElseGet(() -> new ClosedStart(data.mechanism(), data.settings().tStart()));
    return new ClosedMechanism(data.mechanism(), data.formulation(), data.settings(), start);
  }

  private static Model equations(
      ClosedMechanism closed, CompactModel data, UserForceSource userForces) {
    return PenaltySettings.isPenalty(data.closure())
        ? byPenalty(closed, data, userForces)
        : byProjection(closed, data, userForces);
  }

  private static Model byPenalty(
      ClosedMechanism closed, CompactModel data, UserForceSource userForces) {
    PenaltySettings settings = PenaltySettings.of(data.closure());
    return switch (data.knownFormulation()) {
      case DSR -> new PenaltyModel(closed, userForces, settings);
      case RR -> new ResidualPenaltyModel(closed, userForces, settings, Derivatives.DIFFERENCES);
      case RR_JF -> new ResidualPenaltyModel(closed, userForces, settings, Derivatives.RECURSIVE);
      case DTR -> throw data.unknownFormulation();
    };
  }

  private static Model byProjection(
      ClosedMechanism closed, CompactModel data, UserForceSource userForces) {
    return switch (data.knownFormulation()) {
      case DSR -> new ProjectionModel(closed, userForces);
      case RR -> ResidualProjectionModel.of(closed, userForces);
      case RR_JF -> new LinearisedProjectionModel(closed, userForces);
      case DTR -> throw data.unknownFormulation();
    };
  }
}
