package org.mechservice.sim.service;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.mechml.Diagnostic;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.Severity;
import org.mechservice.sim.scene.Finding;
import org.mechservice.sim.scene.SceneAnalysis;

/** What is said of a model as soon as it is read, without waiting for a run to fail. */
final class SceneWarnings {
  private SceneWarnings() {}

  /** Returns the reader's warnings, then joints that move nothing or that no inertia resists. */
  static List<Diagnostic> of(MechmlModel model) {
    List<Diagnostic> warnings = new ArrayList<>(model.warnings());
    double start = model.settings().run().tStart();
    for (Finding finding : SceneAnalysis.of(model.mechanism()).findingsAtStart(start)) {
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
