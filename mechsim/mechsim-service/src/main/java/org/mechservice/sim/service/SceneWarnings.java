package org.mechservice.sim.service;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.sim.scene.Finding;
import org.mechservice.sim.scene.RunForecast;
import org.mechservice.sim.scene.SceneAnalysis;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.catalogue.Severity;

/** What is said of a model as soon as it is read, without waiting for a run to fail. */
final class SceneWarnings {
  private SceneWarnings() {}

  /** Returns them of a run as the file says. */
  static List<Diagnostic> of(MechmlModel model) {
    return of(model, model.settings().formulation(), model.settings().run());
  }

  /**
   * Returns the reader's warnings, then joints that move nothing or that no inertia resists, and
   * whether a run will take very many steps.
   *
   * @param formulation asked for
   * @param run settings of the run
   */
  static List<Diagnostic> of(MechmlModel model, String formulation, RunSettings run) {
    List<Diagnostic> warnings = new ArrayList<>(model.warnings());
    List<Finding> findings =
        new ArrayList<>(SceneAnalysis.of(model.mechanism()).findingsAtStart(run.tStart()));
    findings.addAll(RunForecast.of(model.mechanism(), formulation, run));
    for (Finding finding : findings) {
      warnings.add(
          new Diagnostic(
              Severity.WARNING,
              finding.code(),
              finding.text(),
              finding.origin().file(),
              finding.origin().line(),
              0,
              ""));
    }
    return warnings;
  }
}
