package org.mechservice.solver.simulation;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;

/** Warns if the energy balance of a run shows that its motion is wrong. */
final class EnergyDriftWarning {
  /** Fraction of the energy scale above which the motion is wrong. */
  private static final double FAR = 0.01;

  /** Multiple of the tolerance that the drift may reach by accumulation alone. */
  private static final double TOLERANCES = 1e3;

  private EnergyDriftWarning() {}

  /**
   * Returns the report with a warning if the drift is too large; a strict run that was completed
   * then fails. Without measured work, a damper that acts between two rows would look like a drift.
   */
  static RunReport added(RunReport report, Model model, RunRequest request) {
    boolean measured =
        request.columns().contains(ColumnGroup.ENERGY)
            || request.maxDrift().isPresent()
            || !(ModelParts.of(model).equations() instanceof PowerInput);
    double drift = report.energyDrift().orElse(0) / report.energyScale().orElse(1);
    boolean far = drift > FAR && drift > TOLERANCES * request.settings().relativeTolerance();
    return measured && far
        ? DeferredWarning.added(
            report, warning(report.timeReached(), drift, request.settings()), request)
        : report;
  }

  private static Note warning(double t, double drift, RunSettings settings) {
    String maxStep = Double.isFinite(settings.maxStep()) ? "a shorter maxStep" : "a maxStep";
    return new Note(
        MessageCode.ENERGY_BALANCE_OFF,
        t,
        true,
        "The energy balance is off by "
            + (float) drift
            + " of the energy scale: the integrator has missed a jump, a corner or a short pulse,"
            + " or the tolerances are too loose. Give the integrator "
            + maxStep
            + ", or tighten them.");
  }
}
