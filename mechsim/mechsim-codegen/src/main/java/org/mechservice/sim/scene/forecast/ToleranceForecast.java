package org.mechservice.sim.scene.forecast;

import java.util.Locale;
import java.util.Optional;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.scene.Finding;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.PenaltySettings;

/**
 * Warns before a run of loops by penalty with implicit steps (RR, RR-JF) if its tolerances are
 * nearly as fine as the rounding that these steps leave in the velocities of the loops: the error
 * test then takes rounding for error, which shorter steps do not reduce.
 *
 * <p>That rounding is some 1e-13 of the velocities for every α from 1e3 to 1e11: measured on five
 * scenes, runs completed with tolerances whose sum is 4e-12 or more at velocities of 1, and an
 * absolute one of 5e-13 or more; with finer ones two of the five ended in N-003.
 */
final class ToleranceForecast {
  /** Sum of relative and absolute tolerance: forty times the rounding at a velocity of 1. */
  private static final double FINEST_AT_UNIT_VELOCITY = 4e-12;

  /** Absolute tolerance, which is all that is allowed at rest: some times the rounding. */
  private static final double FINEST_AT_REST = 3e-13;

  private ToleranceForecast() {}

  /**
   * Forecasts a run.
   *
   * @param formulation requested formulation
   * @param closure requested closure
   */
  static Optional<Finding> of(
      MechmlModel model, String formulation, String closure, RunSettings settings) {
    double absolute = settings.velocityTolerance();
    boolean fine =
        settings.relativeTolerance() + absolute < FINEST_AT_UNIT_VELOCITY
            || absolute < FINEST_AT_REST;
    return fine && hasImplicitPenalty(model, formulation, closure, settings)
        ? Optional.of(finding(model, settings))
        : Optional.empty();
  }

  private static boolean hasImplicitPenalty(
      MechmlModel model, String formulation, String closure, RunSettings settings) {
    if (model.mechanism().closures().isEmpty()) {
      return false;
    }
    try {
      FormulationChoice choice = FormulationChoice.of(formulation, closure, settings, model);
      return PenaltySettings.isPenalty(choice.closure())
          && Formulation.find(choice.formulation()).filter(Formulation::isResidual).isPresent();
    } catch (ModelBuildException e) {
      // A combination that cannot be built is refused, with the reason, when the run starts.
      return false;
    }
  }

  private static Finding finding(MechmlModel model, RunSettings settings) {
    return new Finding(
        MessageCode.TOLERANCE_NEAR_ROUNDING,
        String.format(
            Locale.ROOT,
            "relative tolerance %.0e with an absolute one of %.0e for velocities is nearly as fine"
                + " as the rounding that implicit steps by penalty leave in the velocities of the"
                + " loops, 1e-13 of them whatever alpha is: steps will shrink, and the run may end"
                + " in N-003 or N-004; use closure \"projection\", or formulation DSR with ode113,"
                + " or tolerances of 2e-12 and more",
            settings.relativeTolerance(),
            settings.velocityTolerance()),
        model.mechanism().closures().get(0).origin());
  }
}
