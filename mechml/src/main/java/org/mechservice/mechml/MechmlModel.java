package org.mechservice.mechml;

import java.util.List;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;

/**
 * A model file after reading: a mechanism and settings in SI units, with all names resolved.
 *
 * @param mechanism the mechanism
 * @param settings the chosen simulation
 * @param simulations every simulation of the file, in file order
 * @param parameters in file order
 * @param outputs user-defined result columns, in file order
 * @param unused points, vectors and parameters that nothing refers to, such as {@code point "p3" of
 *     body "bar"}
 * @param warnings diagnostics below errors, in file order
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

  /** Returns the mechanism with the events of the chosen simulation. */
  public Mechanism watchedMechanism() {
    return mechanism.withEvents(settings.events());
  }

  /** Creates a model with one simulation and without parameters and outputs. */
  public MechmlModel(Mechanism mechanism, SimulationSettings settings, List<Diagnostic> warnings) {
    this(mechanism, settings, List.of(settings), List.of(), List.of(), List.of(), warnings);
  }
}
