package org.mechservice.sim.scene.forecast;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.scene.Finding;
import org.mechservice.sim.scene.SceneAnalysis;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.mechanism.Mechanism;

/** All findings about a model and its run before it begins, but those about loops. */
public final class RunForecast {
  private RunForecast() {}

  /** Returns whether two runs of a mechanism have the same findings. */
  public static boolean isSame(RunSettings run, RunSettings other) {
    return run.tStart() == other.tStart()
        && run.tEnd() == other.tEnd()
        && run.maxStep() == other.maxStep()
        && run.relativeTolerance() == other.relativeTolerance()
        && run.absoluteTolerance() == other.absoluteTolerance()
        && run.integrator().equals(other.integrator());
  }

  /**
   * Returns the findings that the model does not silence: joints that move nothing, bodies that
   * nothing moves, causes of a long run, dense matrices of large mechanisms, tolerances near
   * rounding, and events that a step may miss.
   *
   * @param formulation requested formulation, {@code auto} or a name
   * @param closure requested closure, {@code auto} or a name
   */
  public static List<Finding> of(
      MechmlModel model, String formulation, String closure, RunSettings settings) {
    Mechanism mechanism = model.mechanism();
    List<Finding> findings =
        new ArrayList<>(SceneAnalysis.of(mechanism).findingsAtStart(settings.tStart()));
    RestCheck.of(model, settings).ifPresent(findings::add);
    // A fast spin also appears in the linearised equations, like a stiff joint.
    SpinForecast.of(mechanism, settings)
        .or(() -> StiffnessForecast.of(model, settings))
        .ifPresent(findings::add);
    DigitsForecast.of(mechanism, formulation, settings).ifPresent(findings::add);
    ShortPulseCheck.of(mechanism, settings).ifPresent(findings::add);
    findings.addAll(FormulaForecast.of(mechanism, settings));
    ToleranceForecast.of(model, formulation, closure, settings).ifPresent(findings::add);
    findings.addAll(DenseForecast.of(model, formulation, settings));
    findings.removeIf(finding -> model.silenced().contains(finding.code()));
    return findings;
  }
}
