package org.mechservice.sim.fmu;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.sim.emit.c.CLoops;
import org.mechservice.sim.emit.c.CModel;
import org.mechservice.sim.emit.c.CVariable;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.IntegrationMethod;

/**
 * A model in C with its description in an FMU.
 *
 * <p>The sources have a header {@code IDENTIFIER.h} with the structure {@code IDENTIFIER_t} of an
 * instance, its numbers of states, parameters, inputs, outputs and event functions, and functions
 * for its start, derivatives, outputs, events, projection and Jacobian.
 *
 * @param name name of the model
 * @param identifier its name in C
 * @param states states, in the order of the C arrays; so are the following
 * @param parameters parameters that can be set
 * @param inputs inputs
 * @param outputs outputs; one with the name of a state is that state
 * @param events names of the event functions
 * @param experiment the run that the model file describes
 * @param sources the C files by name
 */
public record FmuModel(
    String name,
    String identifier,
    List<FmuVariable> states,
    List<FmuVariable> parameters,
    List<FmuVariable> inputs,
    List<FmuVariable> outputs,
    List<String> events,
    Experiment experiment,
    SortedMap<String, String> sources) {
  /** Beginning of the names of all functions of a model in independent coordinates. */
  private static final String INDEPENDENT = "mech_independent";

  /** The sizes of what the steps of a model watch; without it they watch nothing. */
  private static final String WATCHED = "mech_watch_tape.h";

  public FmuModel {
    states = List.copyOf(states);
    parameters = List.copyOf(parameters);
    inputs = List.copyOf(inputs);
    outputs = List.copyOf(outputs);
    events = List.copyOf(events);
    sources = new TreeMap<>(sources);
  }

  /**
   * Returns a printed model.
   *
   * @param run the run that its file describes
   */
  public static FmuModel of(CModel model, RunSettings run) {
    SortedMap<String, String> files = new TreeMap<>(model.searchedFiles());
    return new FmuModel(
        model.modelName(),
        model.name(),
        variables(model.states()),
        variables(model.parameters()),
        variables(model.inputs().variables()),
        variables(model.outputs()),
        model.events().names(),
        new Experiment(
            run.tStart(),
            run.tEnd(),
            run.tStep(),
            run.relativeTolerance(),
            run.absoluteTolerance(),
            run.maxStep(),
            IntegrationMethod.of(run.integrator()).family() == IntegrationMethod.Family.BACKWARD),
        files);
  }

  /**
   * Returns a printed model whose states are independent coordinates alone, so that its state is on
   * the loops wherever the importer moves it; the others are outputs. An open chain remains as it
   * is.
   *
   * @param run the run that its file describes
   * @param wanted names of positions or joints that are to be states; none to choose them
   * @throws IllegalArgumentException if there are no such coordinates; the message says which do
   */
  public static FmuModel inIndependentCoordinates(
      CModel model, RunSettings run, List<String> wanted) {
    FmuModel whole = of(model, run);
    if (!(model.motion() instanceof CLoops loops)) {
      return whole;
    }
    IndependentCoordinates chosen = new IndependentCoordinates(model, loops, wanted);
    SortedMap<String, String> files = new TreeMap<>(whole.sources());
    List<String> quantities =
        FmuSources.QUANTITIES.stream()
            .filter(function -> whole.declares(whole.identifier(), function))
            .toList();
    for (String ending : List.of(".h", ".c")) {
      String text = FmuSources.resource(INDEPENDENT + ending);
      files.put(
          INDEPENDENT + ending,
          ending.equals(".h") ? chosen.header(text, quantities) : chosen.source(text, quantities));
    }
    List<FmuVariable> outputs = new ArrayList<>(whole.outputs());
    chosen.others().forEach(i -> outputs.add(whole.states().get(i)));
    return new FmuModel(
        whole.name(),
        whole.identifier(),
        chosen.states().stream().map(whole.states()::get).toList(),
        whole.parameters(),
        whole.inputs(),
        outputs,
        whole.events(),
        whole.experiment(),
        files);
  }

  /** Returns whether the header with the names of a prefix declares a function. */
  boolean declares(String prefix, String function) {
    return sources.getOrDefault(prefix + ".h", "").contains(prefix + "_" + function + "(");
  }

  /** Returns whether the steps of the model are searched. */
  boolean isWatched() {
    return sources.containsKey(WATCHED);
  }

  /** Returns whether the model has closed loops. */
  boolean hasLoops() {
    return sources.containsKey("mech_loops.c");
  }

  /** Returns whether the states are independent coordinates of closed loops. */
  boolean isIndependent() {
    return sources.containsKey(INDEPENDENT + ".h");
  }

  /** Returns the beginning of the names of the model's functions, and of its header. */
  String prefix() {
    return isIndependent() ? INDEPENDENT : identifier;
  }

  private static List<FmuVariable> variables(List<CVariable> printed) {
    return printed.stream()
        .map(
            variable ->
                new FmuVariable(
                    variable.name(), variable.unit(), variable.description(), variable.start()))
        .toList();
  }

  /**
   * A run as the model file describes it.
   *
   * @param start start time, s
   * @param end end time, s
   * @param step distance of the rows, s
   * @param relativeTolerance of the integrator
   * @param absoluteTolerance of the integrator
   * @param maxStep longest step, s; may be infinite
   * @param stiff whether its integrator is one for stiff models
   */
  public record Experiment(
      double start,
      double end,
      double step,
      double relativeTolerance,
      double absoluteTolerance,
      double maxStep,
      boolean stiff) {}
}
