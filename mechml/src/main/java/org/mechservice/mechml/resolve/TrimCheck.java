package org.mechservice.mechml.resolve;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.mechml.SimulationTask.TrimProblem;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;

/** Checks the names of a trim problem, and that there are as many conditions as unknowns. */
final class TrimCheck {
  private final Mechanism mechanism;
  private final Element trim;
  private final Diagnostics diagnostics;

  private TrimCheck(Mechanism mechanism, Element trim, Diagnostics diagnostics) {
    this.mechanism = mechanism;
    this.trim = trim;
    this.diagnostics = diagnostics;
  }

  /**
   * Reports names that a trim problem cannot have.
   *
   * @param block the simulation
   */
  static void of(
      SimulationTask task,
      Element block,
      Mechanism mechanism,
      List<Output> outputs,
      Diagnostics diagnostics) {
    Optional<TrimProblem> asked =
        task instanceof SimulationTask.StaticEquilibrium rest
            ? rest.trim()
            : task instanceof SimulationTask.Linearization linear
                ? linear.trim()
                : Optional.empty();
    if (asked.isPresent()) {
      Element trim = block.children().get(0).requiredChild("trim");
      new TrimCheck(mechanism, trim, diagnostics).check(asked.get(), outputs);
    }
  }

  private void check(TrimProblem problem, List<Output> outputs) {
    Set<String> unknowns = new LinkedHashSet<>();
    coordinates("q", unknowns);
    coordinates("v", unknowns);
    Set<String> quantities = new LinkedHashSet<>();
    coordinates("a", quantities);
    for (FurtherState state : mechanism.furtherStates()) {
      if (state.role() != FurtherState.Role.SAMPLED) {
        unknowns.add(state.name());
      }
      if (state.role() == FurtherState.Role.INTEGRATED) {
        quantities.add(state.name() + ".rate");
      }
    }
    outputs.forEach(output -> quantities.add(output.name()));
    Set<String> seen = new LinkedHashSet<>();
    for (Element unknown : trim.children("unknown")) {
      String name = unknown.required("name").strip();
      require(unknown, name, unknowns, "no coordinate, velocity, state or input of the model");
      if (!seen.add(name)) {
        error(unknown, Phrase.of("trim: %s is an unknown twice", Quoted.of(name)));
      }
    }
    for (Element condition : trim.children("condition")) {
      String name = condition.required("name").strip();
      require(condition, name, quantities, "no acceleration, rate of a state or output");
    }
    int conditions = problem.conditions().size();
    if (problem.unknowns().size() != conditions) {
      error(
          trim,
          Phrase.of(
              "trim: there are %d unknowns and %d conditions; as many conditions are needed as"
                  + " unknowns",
              problem.unknowns().size(), conditions));
    }
  }

  private void require(Element element, String name, Set<String> known, String what) {
    if (!known.contains(name)) {
      error(
          element,
          Phrase.of(
              "trim: %s is %s%s", Quoted.of(name), what, NearestName.suggestion(name, known)));
    }
  }

  private void error(Element element, String message) {
    diagnostics.error(MessageCode.TRIM_UNUSABLE, element.position(), message);
  }

  private void coordinates(String quantity, Set<String> names) {
    for (int j = 0; j < mechanism.joints().size(); j++) {
      JointType type = mechanism.joints().get(j).type();
      String name = mechanism.joints().get(j).name() + "." + quantity;
      for (int i = 0; i < type.velocityCount() && !mechanism.isDriven(j); i++) {
        names.add(type.velocityCount() == 1 ? name : name + "[" + i + "]");
      }
    }
  }
}
