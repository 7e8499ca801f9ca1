package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.mechanism.Mechanism;

/** All findings about a run before it begins. */
public final class RunForecast {
  private RunForecast() {}

  /** Returns whether two runs of a mechanism have the same findings. */
  public static boolean isSame(RunSettings run, RunSettings other) {
    return run.tStart() == other.tStart()
        && run.tEnd() == other.tEnd()
        && run.maxStep() == other.maxStep()
        && run.relativeTolerance() == other.relativeTolerance()
        && StiffnessForecast.isSame(run.integrator(), other.integrator());
  }

  /**
   * Returns what will make it long, and what it may pass over.
   *
   * @param formulation asked for, {@code auto} or a name
   */
  public static List<Finding> of(Mechanism mechanism, String formulation, RunSettings settings) {
    List<Finding> findings = new ArrayList<>();
    // A spin is fast in the linearised equations too, where it looks like a stiff joint.
    SpinForecast.of(mechanism, settings)
        .or(() -> StiffnessForecast.of(mechanism, settings))
        .ifPresent(findings::add);
    DigitsForecast.of(mechanism, formulation, settings).ifPresent(findings::add);
    ShortPulseCheck.of(mechanism, settings).ifPresent(findings::add);
    findings.addAll(FormulaForecast.of(mechanism, settings));
    return findings;
  }
}
