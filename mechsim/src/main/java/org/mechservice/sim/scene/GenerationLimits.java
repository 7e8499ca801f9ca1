package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.mechservice.solver.mechanism.Event;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.UserForceElement;

/** What is simulated without generated code. */
public final class GenerationLimits {
  /** More names would hide the message. */
  private static final int MOST_NAMES = 5;

  private GenerationLimits() {}

  /** Returns what no code is generated for, such as {@code forces "f1", "f2"}. */
  public static List<String> notGenerated(Mechanism mechanism, FormulationChoice choice) {
    List<String> beyond = new ArrayList<>();
    if (choice.formulation().equals("RR-JF")) {
      beyond.add("formulation " + choice.formulation());
    }
    add(beyond, "constraints", mechanism.closures().stream().map(LoopClosure::name));
    add(
        beyond,
        "forces written as classes",
        mechanism.forces().stream()
            .filter(UserForceElement.class::isInstance)
            .map(ForceElement::name));
    add(beyond, "tunable parameters", mechanism.parameters().stream().map(Parameter::name));
    add(beyond, "events", mechanism.events().stream().map(Event::name));
    List<Double> jumps = mechanism.timeJumps(0, Double.POSITIVE_INFINITY);
    add(beyond, "jumps at the times", jumps.stream().map(time -> time + " s"));
    return beyond;
  }

  private static void add(List<String> beyond, String kind, Stream<String> names) {
    List<String> quoted = names.map(name -> "\"" + name + "\"").toList();
    if (!quoted.isEmpty()) {
      int more = quoted.size() - MOST_NAMES;
      beyond.add(
          kind
              + " "
              + String.join(", ", quoted.subList(0, Math.min(MOST_NAMES, quoted.size())))
              + (more > 0 ? " and " + more + " more" : ""));
    }
  }
}
