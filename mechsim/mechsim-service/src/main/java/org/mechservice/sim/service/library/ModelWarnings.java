package org.mechservice.sim.service.library;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.sim.scene.forecast.RunForecast;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;

/** The warnings of a model and of its runs that are known before a run begins. */
public final class ModelWarnings {
  private ModelWarnings() {}

  /** Returns the warnings of a run with the settings of the file. */
  public static List<Diagnostic> of(MechmlModel model) {
    SimulationSettings settings = model.settings();
    return RunForecast.warnings(model, settings.formulation(), settings.closure(), settings.run());
  }

  /**
   * Returns all warnings of a run; empty if they are those of its file. They differ if the run has
   * another formulation, closure, integrator, end, tolerance or largest step, or if the model is
   * read with other options.
   */
  static Optional<List<Diagnostic>> differing(
      LoadedModel source, String formulation, String closure, RunSettings run) {
    RunSettings file = source.model().settings().run();
    boolean sameMethods =
        formulation.equals(source.model().settings().formulation())
            && closure.equals(source.model().settings().closure());
    return source.options().equals(ReadOptions.NONE) && sameMethods && RunForecast.isSame(run, file)
        ? Optional.empty()
        : Optional.of(RunForecast.warnings(source.model(), formulation, closure, run));
  }

  /**
   * Returns the warnings of a run that differ from those of its file, as entries of a set-up:
   * {@code warnings} is their number; {@code warning.1} and so on are code, file, line, column,
   * path and text, separated by tabs. {@code silenced} are the codes of silenced warnings.
   */
  public static Map<String, String> ofSetUp(
      LoadedModel source, String formulation, String closure, RunSettings run) {
    Map<String, String> facts = new LinkedHashMap<>();
    if (!source.model().silenced().isEmpty()) {
      facts.put(
          "silenced",
          source.model().silenced().stream()
              .map(MessageCode::code)
              .sorted()
              .collect(Collectors.joining(" ")));
    }
    differing(source, formulation, closure, run)
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
