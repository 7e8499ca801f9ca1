package org.mechservice.mechml;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.SimulationTask.Linearization;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.solver.api.ModelParameter;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.AnalysisKind;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;

/** A model file after reading: a mechanism and settings in SI units, with all names resolved. */
public final class MechmlModel {
  private final Mechanism mechanism;
  private final int inputCount;
  private final SimulationSettings settings;
  private final List<SimulationSettings> simulations;
  private final List<ModelParameter> parameters;
  private final List<Output> outputs;
  private final List<String> unused;
  private final List<Diagnostic> warnings;
  private final Set<MessageCode> silenced;
  private final Scenery scenery;
  private final List<String> dataFiles;

  /** Kept, since it takes long to compute and all callers use the same one. */
  private Optional<ClosedStart> closedStart = Optional.empty();

  /**
   * Creates a model.
   *
   * @param mechanism the mechanism
   * @param inputCount number of the last of its parameters that are inputs
   * @param settings the chosen simulation
   * @param simulations every simulation of the file, in file order
   * @param parameters in file order
   * @param outputs user-defined result columns, in file order
   * @param unused points, vectors and parameters that nothing refers to, such as {@code point "p3"
   *     of body "bar"}
   * @param warnings diagnostics below errors, in file order, without the silenced ones
   * @param silenced warnings that are silenced
   * @param scenery what the file says for the eye beside the mechanism
   * @param dataFiles of tables, each with how it is written, such as {@code table "road": road.csv,
   *     cells between semicolons, decimals with a comma}
   */
  public MechmlModel(
      Mechanism mechanism,
      int inputCount,
      SimulationSettings settings,
      List<SimulationSettings> simulations,
      List<ModelParameter> parameters,
      List<Output> outputs,
      List<String> unused,
      List<Diagnostic> warnings,
      Set<MessageCode> silenced,
      Scenery scenery,
      List<String> dataFiles) {
    this.mechanism = mechanism;
    this.inputCount = inputCount;
    this.settings = settings;
    this.simulations = List.copyOf(simulations);
    this.parameters = List.copyOf(parameters);
    this.outputs = List.copyOf(outputs);
    this.unused = List.copyOf(unused);
    this.warnings = List.copyOf(warnings);
    this.silenced = Set.copyOf(silenced);
    this.scenery = scenery;
    this.dataFiles = List.copyOf(dataFiles);
  }

  /** Creates a model of whose bodies masses alone are known. */
  public MechmlModel(
      Mechanism mechanism,
      int inputCount,
      SimulationSettings settings,
      List<SimulationSettings> simulations,
      List<ModelParameter> parameters,
      List<Output> outputs,
      List<String> unused,
      List<Diagnostic> warnings,
      Set<MessageCode> silenced) {
    this(
        mechanism,
        inputCount,
        settings,
        simulations,
        parameters,
        outputs,
        unused,
        warnings,
        silenced,
        Scenery.NONE,
        List.of());
  }

  /** Creates a model none of whose parameters is an input. */
  public MechmlModel(
      Mechanism mechanism,
      SimulationSettings settings,
      List<SimulationSettings> simulations,
      List<ModelParameter> parameters,
      List<Output> outputs,
      List<String> unused,
      List<Diagnostic> warnings) {
    this(mechanism, 0, settings, simulations, parameters, outputs, unused, warnings, Set.of());
  }

  /** Creates a model with one simulation and without parameters and outputs. */
  public MechmlModel(Mechanism mechanism, SimulationSettings settings, List<Diagnostic> warnings) {
    this(mechanism, settings, List.of(settings), List.of(), List.of(), List.of(), warnings);
  }

  /** Returns the mechanism. */
  public Mechanism mechanism() {
    return mechanism;
  }

  /**
   * Returns the number of the last of the mechanism's parameters that are inputs: all inputs of the
   * file if it was read so, else none.
   */
  public int inputCount() {
    return inputCount;
  }

  /** Returns the chosen simulation. */
  public SimulationSettings settings() {
    return settings;
  }

  /** Returns every simulation of the file, in file order. */
  public List<SimulationSettings> simulations() {
    return simulations;
  }

  /** Returns the parameters in file order. */
  public List<ModelParameter> parameters() {
    return parameters;
  }

  /** Returns the user-defined result columns, in file order. */
  public List<Output> outputs() {
    return outputs;
  }

  /** Returns the points, vectors and parameters that nothing refers to. */
  public List<String> unused() {
    return unused;
  }

  /** Returns the files of tables, each with how it is written, in file order. */
  public List<String> dataFiles() {
    return dataFiles;
  }

  /** Returns the diagnostics below errors, in file order, without the silenced ones. */
  public List<Diagnostic> warnings() {
    return warnings;
  }

  /** Returns the warnings that are silenced, by the file or the options of its reading. */
  public Set<MessageCode> silenced() {
    return silenced;
  }

  /**
   * Returns the solids that a body, or the root, consists of, in file order; none if its mass is
   * given by numbers.
   */
  public List<Solid> solids(String body) {
    return scenery.solids().getOrDefault(body, List.of());
  }

  /** Returns what a body is shown as, in file order; nothing if its solids say it. */
  public List<Look> looks(String body) {
    return scenery.looks().getOrDefault(body, List.of());
  }

  /** Returns what ropes, cables and muscles pass, by their names. */
  public Map<String, Route> routes() {
    return scenery.routes();
  }

  /** Returns the surfaces of contacts and tyres whose height changes, by their names. */
  public Map<String, Road> roads() {
    return scenery.roads();
  }

  /** Returns the model with an analysis in place of its chosen simulation. */
  public MechmlModel analysed(AnalysisKind kind) {
    RunSettings run = settings.run().withIntegrator(MethodNames.NONE);
    SimulationTask task =
        switch (kind) {
          case EQUILIBRIUM -> SimulationTask.StaticEquilibrium.DEFAULT;
          case MODES -> new Linearization(false, Linearization.Result.MODES);
          case LINEARISE -> new Linearization(false, Linearization.Result.EQUATIONS);
          case LINEAR_SYSTEM -> new Linearization(false, Linearization.Result.SYSTEM);
          case KINEMATICS -> new SimulationTask.Kinematic();
          case INVERSE_DYNAMICS -> new SimulationTask.InverseDynamic();
        };
    SimulationSettings other =
        new SimulationSettings(
            settings.name(),
            task,
            kind == AnalysisKind.EQUILIBRIUM ? run.withOutput(run.tStart(), run.tStep()) : run,
            settings.absoluteTolerances(),
            settings.formulation(),
            settings.closure(),
            settings.columns(),
            settings.events());
    return new MechmlModel(
        mechanism,
        inputCount,
        other,
        simulations,
        parameters,
        outputs,
        unused,
        warnings,
        silenced,
        scenery,
        dataFiles);
  }

  /** Returns the mechanism with the events of the chosen simulation. */
  public Mechanism watchedMechanism() {
    return mechanism.withEvents(settings.events());
  }

  /**
   * Returns the mechanism with its loops closed, computed once per time.
   *
   * @param time start of a run, s
   */
  public synchronized ClosedStart closedStart(double time) {
    ClosedStart start =
        closedStart
            .filter(known -> known.time() == time)
            .orElseGet(() -> new ClosedStart(mechanism, time));
    closedStart = Optional.of(start);
    return start;
  }
}
