package org.mechservice.mechml.resolve.simulation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.mechservice.mechml.AbsoluteTolerances;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.mechml.SimulationTask.Linearization;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.SettingReader;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.closure.PenaltySettings;
import org.mechservice.solver.mechanism.Event;

/** Reads {@code MBSsimulation}: task, time set, tolerances and method. */
final class SimulationReader {
  private static final String ALL = "all";

  /** Frequencies of a response: their number if it is left out, and the largest number. */
  private static final int POINTS = 200;

  private static final int MOST_POINTS = 100_000;

  /** Placeholder in the settings of a task that is not integrated. */
  private static final IntegratorReader.Choice NO_INTEGRATOR =
      new IntegratorReader.Choice(
          MethodNames.AUTO,
          1e-5,
          AbsoluteTolerances.uniform(1e-5),
          Double.POSITIVE_INFINITY,
          0,
          0,
          Accuracy.STANDARD);

  /** The integrator of a run whose file names none. */
  private static final IntegratorReader.Choice LEFT_TO_SERVICE =
      new IntegratorReader.Choice(
          MethodNames.AUTO,
          1e-6,
          AbsoluteTolerances.uniform(1e-8),
          Double.POSITIVE_INFINITY,
          0,
          0,
          Accuracy.STANDARD);

  private static final TimeSetReader.TimeSet THE_START = new TimeSetReader.TimeSet(0, 0, 1);

  private final ValueReader values;
  private final TimeSetReader timeSets;
  private final IntegratorReader integrators;
  private final Optional<EventsReader> eventsReader;
  private final Diagnostics diagnostics;

  SimulationReader(
      ValueReader values, Optional<EventsReader> eventsReader, Diagnostics diagnostics) {
    this.eventsReader = eventsReader;
    this.values = values;
    this.timeSets = new TimeSetReader(values, diagnostics);
    this.integrators = new IntegratorReader(values, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Returns the settings; empty after a reported error. */
  Optional<SimulationSettings> read(Element simulation) {
    Element asked = simulation.children().get(0);
    Optional<TimeSetReader.TimeSet> time =
        asked.child("timeSet").map(timeSets::read).orElse(Optional.of(THE_START));
    Optional<IntegratorReader.Choice> integrator =
        asked
            .child("integrator")
            .map(integrators::read)
            .orElse(Optional.of(isIntegrated(asked) ? LEFT_TO_SERVICE : NO_INTEGRATOR));
    Optional<SimulationTask> task = task(asked);
    List<Event> events = eventsReader.map(r -> r.read(asked.children("event"))).orElse(List.of());
    List<String> columns = asked.child("output").map(this::columns).orElse(List.of());
    Optional<Element> formulation = asked.child("formulation");
    Optional<String> closure = formulation.map(this::closure).orElse(Optional.of(MethodNames.AUTO));
    if (time.isEmpty() || integrator.isEmpty() || task.isEmpty() || closure.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new SimulationSettings(
            simulation.attribute("name").orElse(""),
            task.get(),
            run(time.get(), integrator.get()),
            integrator.get().absoluteTolerances(),
            formulation.map(f -> f.required("name")).orElse(MethodNames.AUTO),
            closure.get(),
            columns,
            events));
  }

  /**
   * Returns the closure, with the numbers of penalty after its name; empty if one of them is
   * invalid.
   */
  private Optional<String> closure(Element formulation) {
    String closure = formulation.attribute("closure").orElse(MethodNames.AUTO);
    List<String> numbers = new ArrayList<>();
    boolean wrong = false;
    for (String name : List.of("alpha", "omega", "mu")) {
      if (formulation.attribute(name).isPresent()) {
        OptionalDouble number = values.number(formulation, name);
        number.ifPresent(value -> numbers.add(name + "=" + value));
        wrong |= number.isEmpty();
      }
    }
    if (wrong || numbers.isEmpty()) {
      return wrong ? Optional.empty() : Optional.of(closure);
    }
    if (!closure.equals(PenaltySettings.CLOSURE)) {
      return wrong(formulation, "alpha, omega and mu belong to closure=\"penalty\"");
    }
    String penalty = closure + ":" + String.join(",", numbers);
    try {
      PenaltySettings.of(penalty);
    } catch (IllegalArgumentException e) {
      return wrong(formulation, String.valueOf(e.getMessage()));
    }
    return Optional.of(penalty);
  }

  private Optional<String> wrong(Element element, String why) {
    diagnostics.error(
        MessageCode.INTEGRATOR_SETTING, element.position(), element.label() + ": " + why);
    return Optional.empty();
  }

  private static RunSettings run(TimeSetReader.TimeSet time, IntegratorReader.Choice integrator) {
    AbsoluteTolerances tolerances = integrator.absoluteTolerances();
    return new RunSettings(
        time.start(),
        time.end(),
        time.step(),
        integrator.name(),
        integrator.relativeTolerance(),
        tolerances.position(),
        integrator.maxStep(),
        integrator.initialStep(),
        integrator.maxOrder(),
        tolerances.angle(),
        tolerances.velocity(),
        tolerances.angularVelocity(),
        integrator.accuracy());
  }

  private static boolean isIntegrated(Element asked) {
    return asked.name().equals("dynamic");
  }

  private Optional<SimulationTask> task(Element asked) {
    return switch (asked.name()) {
      case "kinematic" -> Optional.of(new SimulationTask.Kinematic());
      case "inverseDynamic" -> Optional.of(new SimulationTask.InverseDynamic());
      case "static" -> equilibrium(asked);
      case "linearize" -> linearization(asked);
      default -> Optional.of(new SimulationTask.Dynamic());
    };
  }

  private Optional<SimulationTask> linearization(Element asked) {
    boolean atEquilibrium = asked.attribute("at").map("equilibrium"::equals).orElse(false);
    String otherwise =
        asked.attribute("modes").map("true"::equals).orElse(true) ? "modes" : "equations";
    Linearization.Result gives =
        Linearization.Result.valueOf(
            asked.attribute("gives").orElse(otherwise).toUpperCase(Locale.ROOT));
    if (asked.attribute("gives").isPresent() && asked.attribute("modes").isPresent()) {
      diagnostics.error(
          MessageCode.FREQUENCIES,
          asked.position(),
          "linearize: gives says what is wanted; leave modes out");
      return Optional.empty();
    }
    boolean grid =
        asked.attribute("from").isPresent()
            || asked.attribute("to").isPresent()
            || asked.attribute("points").isPresent();
    if (gives != Linearization.Result.RESPONSE) {
      if (grid) {
        diagnostics.error(
            MessageCode.FREQUENCIES,
            asked.position(),
            "linearize: from, to and points are the frequencies of gives=\"response\"");
        return Optional.empty();
      }
      return Optional.of(new Linearization(atEquilibrium, gives).about(trim(asked)));
    }
    if (asked.attribute("from").isEmpty() || asked.attribute("to").isEmpty()) {
      diagnostics.error(
          MessageCode.FREQUENCIES,
          asked.position(),
          "linearize: gives=\"response\" needs from and to, the lowest and the highest frequency"
              + " in Hz");
      return Optional.empty();
    }
    OptionalDouble from = values.number(asked, "from");
    OptionalDouble to = values.number(asked, "to");
    OptionalDouble points =
        asked.attribute("points").isPresent()
            ? values.number(asked, "points")
            : OptionalDouble.of(POINTS);
    if (from.isEmpty() || to.isEmpty() || points.isEmpty()) {
      return Optional.empty();
    }
    double count = points.getAsDouble();
    if (!(from.getAsDouble() > 0)
        || !(to.getAsDouble() > from.getAsDouble())
        || !(count >= 2 && count <= MOST_POINTS && count == Math.rint(count))) {
      diagnostics.error(
          MessageCode.FREQUENCIES,
          asked.position(),
          Phrase.of(
              "linearize: from is %s, to is %s, points is %s; 0 < from < to is needed, and a whole"
                  + " number of points from 2 to %d",
              from.getAsDouble(), to.getAsDouble(), count, MOST_POINTS));
      return Optional.empty();
    }
    return Optional.of(
        new Linearization(
            atEquilibrium, gives, from.getAsDouble(), to.getAsDouble(), (int) count, trim(asked)));
  }

  private Optional<SimulationTask> equilibrium(Element asked) {
    SimulationTask.StaticEquilibrium open = SimulationTask.StaticEquilibrium.DEFAULT;
    SettingReader settings = new SettingReader(values, diagnostics);
    OptionalDouble tolerance =
        settings.read(
            asked, "tolerance", open.tolerance(), x -> x > 0 && x < 1, "must lie between 0 and 1");
    OptionalDouble iterations =
        settings.read(
            asked,
            "maxIterations",
            open.maxIterations(),
            x -> x >= 1 && x <= 1e6 && x == Math.rint(x),
            "must be a whole number from 1 to 1000000");
    return tolerance.isPresent() && iterations.isPresent()
        ? Optional.of(
            new SimulationTask.StaticEquilibrium(
                tolerance.getAsDouble(), (int) iterations.getAsDouble(), trim(asked)))
        : Optional.empty();
  }

  /** Returns the trim problem that a simulation holds; {@code TrimCheck} checks its names. */
  private Optional<SimulationTask.TrimProblem> trim(Element asked) {
    boolean wanted = asked.attribute("at").map("trim"::equals).orElse(false);
    Optional<Element> trim = asked.child("trim");
    boolean ofStart = asked.attribute("at").isPresent() && !wanted;
    if ((wanted && trim.isEmpty()) || (ofStart && trim.isPresent())) {
      diagnostics.error(
          MessageCode.TRIM_UNUSABLE,
          asked.position(),
          asked.label() + ": at=\"trim\" and the element <trim> belong together");
    }
    if (trim.isEmpty()) {
      return Optional.empty();
    }
    List<String> unknowns = new ArrayList<>();
    Map<String, Double> conditions = new LinkedHashMap<>();
    for (Element unknown : trim.get().children("unknown")) {
      unknowns.add(unknown.required("name").strip());
    }
    for (Element condition : trim.get().children("condition")) {
      OptionalDouble value =
          condition.attribute("value").isPresent()
              ? values.number(condition, "value")
              : OptionalDouble.of(0);
      String name = condition.required("name").strip();
      if (conditions.put(name, value.orElse(0)) != null) {
        diagnostics.error(
            MessageCode.TRIM_UNUSABLE,
            condition.position(),
            Phrase.of("trim: %s has two conditions", Quoted.of(name)));
      }
    }
    return Optional.of(new SimulationTask.TrimProblem(unknowns, conditions));
  }

  private List<String> columns(Element output) {
    for (String foreign : List.of("name", "expression", "unit")) {
      if (output.attribute(foreign).isPresent()) {
        error(
            output,
            Phrase.of("attribute %s belongs to an output in <Outputs>", Quoted.of(foreign)));
      }
    }
    if (output.attribute("columns").isEmpty()) {
      error(output, "attribute \"columns\" is missing");
      return List.of();
    }
    List<String> columns = new ArrayList<>();
    for (String item : output.required("columns").split(";", -1)) {
      String group = item.strip();
      if (group.equals(ALL)) {
        columns.addAll(SimulationSettings.COLUMN_GROUPS);
      } else if (SimulationSettings.COLUMN_GROUPS.contains(group)) {
        columns.add(group);
      } else {
        unknownGroup(output, group);
      }
    }
    return columns.stream().distinct().toList();
  }

  private void unknownGroup(Element output, String group) {
    if (group.contains(",")) {
      error(output, "groups of columns are separated by \";\", not by \",\"");
      return;
    }
    Optional<String> nearest = NearestName.of(group, SimulationSettings.COLUMN_GROUPS);
    error(
        output,
        Phrase.of(
            "there are no columns %s%s",
            Quoted.of(group),
            nearest
                .map(n -> "; did you mean " + Quoted.of(n) + "?")
                .orElse(
                    "; there are "
                        + String.join(", ", SimulationSettings.COLUMN_GROUPS)
                        + " and all")));
  }

  private void error(Element output, String message) {
    diagnostics.error(
        MessageCode.OUTPUT_INCOMPLETE, output.position(), output.label() + ": " + message);
  }
}
