package org.mechservice.sim.scene.forecast;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.sim.scene.Finding;
import org.mechservice.sim.scene.InertiaCheck;
import org.mechservice.sim.scene.IntegratorSelection;
import org.mechservice.sim.scene.LoopAnalysis;
import org.mechservice.sim.scene.SceneAnalysis;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.catalogue.Severity;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * All that is said about a model and its run before it begins. The check of a model, the service
 * before a run, strict requests and the library take it from here, so that they say the same.
 */
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
   * Returns the warnings before a run: those of the file's reader, then the findings. A start that
   * does not close the loops is left out: the run is refused, or moves it and says so (N-040,
   * N-041).
   *
   * @param formulation requested formulation, {@code auto} or a name
   * @param closure requested closure, {@code auto} or a name
   */
  public static List<Diagnostic> warnings(
      MechmlModel model, String formulation, String closure, RunSettings settings) {
    List<Diagnostic> warnings = new ArrayList<>(model.warnings());
    of(model, formulation, closure, settings).stream()
        .filter(finding -> finding.code() != MessageCode.LOOPS_OPEN_AT_START)
        .map(RunForecast::warning)
        .forEach(warnings::add);
    return warnings;
  }

  private static Diagnostic warning(Finding finding) {
    return new Diagnostic(
        Severity.WARNING,
        finding.code(),
        finding.text(),
        finding.origin().file(),
        finding.origin().line(),
        0,
        "");
  }

  /**
   * Returns the findings that the model does not silence: of its loops, joints that move nothing,
   * bodies that nothing moves, causes of a long run, dense matrices of large mechanisms, and
   * tolerances near rounding.
   *
   * @param formulation requested formulation, {@code auto} or a name
   * @param closure requested closure, {@code auto} or a name
   * @param asked settings of the run; the integrator may be {@code auto}
   */
  public static List<Finding> of(
      MechmlModel model, String formulation, String closure, RunSettings asked) {
    Mechanism mechanism = model.mechanism();
    boolean dynamic = model.settings().task() instanceof SimulationTask.Dynamic;
    RunSettings settings = dynamic ? withIntegrator(mechanism, formulation, asked) : asked;
    List<Finding> findings = new ArrayList<>(LoopAnalysis.findings(model, settings.tStart()));
    List<Finding> massless = SceneAnalysis.of(mechanism).findings();
    findings.addAll(massless);
    if (massless.isEmpty() && dynamic) {
      InertiaCheck.of(mechanism, settings.tStart()).ifPresent(findings::add);
    }
    RestCheck.of(model, settings).ifPresent(findings::add);
    // A fast spin also appears in the linearised equations, like a stiff joint.
    SpinForecast.of(mechanism, settings)
        .or(() -> StiffnessForecast.of(model, settings))
        .ifPresent(findings::add);
    DigitsForecast.of(mechanism, formulation, settings).ifPresent(findings::add);
    findings.addAll(FormulaForecast.of(mechanism, settings));
    ToleranceForecast.of(model, formulation, closure, settings).ifPresent(findings::add);
    findings.addAll(DenseForecast.of(model, formulation, settings));
    findings.removeIf(finding -> model.silenced().contains(finding.code()));
    return findings;
  }

  /** Returns the settings with the integrator that the run will have if it is to be chosen. */
  private static RunSettings withIntegrator(
      Mechanism mechanism, String formulation, RunSettings asked) {
    return asked.integrator().equals(MethodNames.AUTO)
        ? asked.withIntegrator(IntegratorSelection.of(formulation, mechanism, asked).integrator())
        : asked;
  }
}
