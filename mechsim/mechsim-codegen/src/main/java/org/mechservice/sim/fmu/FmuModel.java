package org.mechservice.sim.fmu;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * A model in C with what an FMU says about it.
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
  public FmuModel {
    states = List.copyOf(states);
    parameters = List.copyOf(parameters);
    inputs = List.copyOf(inputs);
    outputs = List.copyOf(outputs);
    events = List.copyOf(events);
    sources = new TreeMap<>(sources);
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
   */
  public record Experiment(
      double start,
      double end,
      double step,
      double relativeTolerance,
      double absoluteTolerance,
      double maxStep) {}
}
