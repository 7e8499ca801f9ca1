package org.mechservice.mechml.resolve;

import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MessageCode;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.api.RunSettings;

/** Reads {@code dynamic}: when, how accurately and by which method to simulate. */
final class SimulationReader {
  private static final List<String> FORMULATIONS = List.of("auto", "DTR");

  private final TimeSetReader timeSets;
  private final IntegratorReader integrators;
  private final Diagnostics diagnostics;

  SimulationReader(ValueReader values, Diagnostics diagnostics) {
    this.timeSets = new TimeSetReader(values, diagnostics);
    this.integrators = new IntegratorReader(values, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Returns the settings; empty if something was wrong and has been reported. */
  Optional<SimulationSettings> read(Element dynamic) {
    Optional<TimeSet> time = timeSets.read(dynamic.requiredChild("timeSet"));
    Optional<IntegratorChoice> integrator = integrators.read(dynamic.requiredChild("integrator"));
    Optional<String> formulation =
        dynamic.child("formulation").map(this::formulation).orElse(Optional.of("auto"));
    if (time.isEmpty() || integrator.isEmpty() || formulation.isEmpty()) {
      return Optional.empty();
    }
    RunSettings run =
        new RunSettings(
            time.get().start(),
            time.get().end(),
            time.get().step(),
            integrator.get().name(),
            integrator.get().relativeTolerance(),
            integrator.get().absoluteTolerance(),
            integrator.get().maxStep(),
            integrator.get().initialStep(),
            integrator.get().maxOrder());
    return Optional.of(new SimulationSettings(run, formulation.get()));
  }

  private Optional<String> formulation(Element element) {
    String name = element.required("name");
    if (FORMULATIONS.contains(name)) {
      return Optional.of(name);
    }
    diagnostics.error(
        MessageCode.FORMULATION,
        element.place(),
        Phrase.of("formulation %s is not available; it has auto and DTR", Quoted.of(name)));
    return Optional.empty();
  }
}
