package org.mechservice.mechml;

import java.util.List;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;

/**
 * A model file, read and resolved: SI units, numbers only.
 *
 * @param mechanism the mechanism
 * @param settings the simulation wanted
 * @param simulations every simulation of the file, in file order
 * @param parameters in file order
 * @param outputs columns of its author's own, in file order
 * @param unused points, vectors and parameters that nothing refers to, such as {@code point "p3" of
 *     body "bar"}
 * @param warnings what is worth knowing, in file order; no errors
 */
public record MechmlModel(
    Mechanism mechanism,
    SimulationSettings settings,
    List<SimulationSettings> simulations,
    List<ModelParameter> parameters,
    List<Output> outputs,
    List<String> unused,
    List<Diagnostic> warnings) {
  public MechmlModel {
    simulations = List.copyOf(simulations);
    parameters = List.copyOf(parameters);
    outputs = List.copyOf(outputs);
    unused = List.copyOf(unused);
    warnings = List.copyOf(warnings);
  }

  /** Returns the mechanism with what happens along the simulation wanted. */
  public Mechanism watchedMechanism() {
    return mechanism.withEvents(settings.events());
  }

  /** A model with one simulation, and neither parameters nor outputs of its own. */
  public MechmlModel(Mechanism mechanism, SimulationSettings settings, List<Diagnostic> warnings) {
    this(mechanism, settings, List.of(settings), List.of(), List.of(), List.of(), warnings);
  }
}
