package org.mechservice.sim.service;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.sim.scene.RunForecast;
import org.mechservice.solver.api.RunSettings;

/**
 * What is said of a run before it begins where that is not what was said of the file: the run has
 * another formulation, integrator, end, tolerance or largest step, or the model is read with other
 * options. It travels among the facts of a set-up: {@code warnings} is how many there are, {@code
 * warning.1} and so on are code, file, line, column, path and text, with tabs between.
 */
final class RunWarnings {
  private RunWarnings() {}

  /** Returns all warnings of a run; empty if those of its file hold. */
  static Optional<List<Diagnostic>> of(LoadedModel source, String formulation, RunSettings run) {
    RunSettings file = source.model().settings().run();
    boolean sameFormulation = formulation.equals(source.model().settings().formulation());
    return source.options().equals(ReadOptions.NONE)
            && sameFormulation
            && RunForecast.isSame(run, file)
        ? Optional.empty()
        : Optional.of(SceneWarnings.of(source.model(), formulation, run));
  }

  /** Returns them as facts of a set-up. */
  static Map<String, String> facts(LoadedModel source, String formulation, RunSettings run) {
    Map<String, String> facts = new LinkedHashMap<>();
    of(source, formulation, run)
        .ifPresent(
            warnings -> {
              facts.put("warnings", String.valueOf(warnings.size()));
              for (int i = 0; i < warnings.size(); i++) {
                facts.put("warning." + (i + 1), text(warnings.get(i)));
              }
            });
    return facts;
  }

  private static String text(Diagnostic said) {
    return String.join(
        "\t",
        said.code().code(),
        said.file(),
        String.valueOf(said.line()),
        String.valueOf(said.column()),
        said.path(),
        said.message());
  }
}
