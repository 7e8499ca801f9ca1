package org.mechservice.solver.simulation;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.catalogue.MessageCode;

/** Warns if the energy balance of a run shows that its motion is wrong. */
final class EnergyDriftWarning {
  /** Part of the energy scale by which no right motion drifts. */
  private static final double FAR = 0.01;

  /** Tolerances that add up to a drift without anything having been missed. */
  private static final double TOLERANCES = 1e3;

  private EnergyDriftWarning() {}

  /**
   * Returns the report with a warning beside its other notes, if there is reason for one; it ends a
   * strict run that was completed. Where work is not measured, a damper that acts between two rows
   * looks like a drift.
   */
  static RunReport added(RunReport report, Model model, RunRequest request) {
    boolean measured =
        request.columns().contains(ColumnGroup.ENERGY)
            || request.maxDrift().isPresent()
            || !(ModelParts.of(model).equations() instanceof PowerInput);
    double drift = report.energyDrift().orElse(0) / report.energyScale().orElse(1);
    boolean far = drift > FAR && drift > TOLERANCES * request.settings().relativeTolerance();
    return measured && far
        ? DeferredWarning.added(report, warning(report.timeReached(), drift), request.strict())
        : report;
  }

  private static Note warning(double t, double drift) {
    return new Note(
        MessageCode.ENERGY_BALANCE_OFF,
        t,
        true,
        "The energy balance is off by "
            + (float) drift
            + " of the energy scale: the integrator has gone past a jump, a corner or a brief push,"
            + " or the tolerances are too loose. Give the integrator a maxStep, or tighten them.");
  }
}
