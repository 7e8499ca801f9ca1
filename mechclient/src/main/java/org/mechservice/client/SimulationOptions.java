package org.mechservice.client;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.OPT_ABS_TOL;
import org.mechservice.idl.OPT_ANALYSIS;
import org.mechservice.idl.OPT_CLOSURE;
import org.mechservice.idl.OPT_CODE;
import org.mechservice.idl.OPT_COLUMNS;
import org.mechservice.idl.OPT_COMPACT;
import org.mechservice.idl.OPT_FORMULATION;
import org.mechservice.idl.OPT_INPUTS;
import org.mechservice.idl.OPT_INTEGRATOR;
import org.mechservice.idl.OPT_MAX_DRIFT;
import org.mechservice.idl.OPT_REL_TOL;
import org.mechservice.idl.OPT_SET;
import org.mechservice.idl.OPT_SILENCE;
import org.mechservice.idl.OPT_SIMULATION;
import org.mechservice.idl.OPT_SOURCE_PART;
import org.mechservice.idl.OPT_STANDALONE;
import org.mechservice.idl.OPT_STRICT;
import org.mechservice.idl.OPT_TEXT_PART;
import org.mechservice.idl.OPT_TUNABLE;
import org.mechservice.idl.OPT_T_END;
import org.mechservice.idl.OPT_T_STEP;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.catalogue.AnalysisKind;
import org.mechservice.solver.catalogue.SourceLanguage;

/**
 * Options of a simulation that differ from the model's file. Immutable: every method returns a new
 * value.
 *
 * <pre>{@code
 * SimulationOptions.asInFile().relativeTolerance(1e-9).endTime(10)
 * }</pre>
 *
 * <p>The server checks the values and rejects unknown or unusable ones with {@link
 * InvalidOptionException}.
 */
public final class SimulationOptions {
  /** Every column group that the model has. */
  private static final String ALL_COLUMNS = "all";

  /** Options that only an integration in time has. */
  private static final Set<String> OF_INTEGRATION =
      Set.of(
          OPT_FORMULATION.value,
          OPT_CLOSURE.value,
          OPT_INTEGRATOR.value,
          OPT_REL_TOL.value,
          OPT_ABS_TOL.value,
          Accuracy.OPTION,
          OPT_MAX_DRIFT.value);

  private static final SimulationOptions AS_IN_FILE =
      new SimulationOptions(Map.of(), Map.of(), Set.of(), Set.of());

  private final Map<String, String> texts;
  private final Map<String, String> parameters;
  private final Set<String> tunable;
  private final Set<String> silenced;

  private SimulationOptions(
      Map<String, String> texts,
      Map<String, String> parameters,
      Set<String> tunable,
      Set<String> silenced) {
    this.texts = texts;
    this.parameters = parameters;
    this.tunable = tunable;
    this.silenced = silenced;
  }

  /** Returns the settings of the model's file, unchanged. */
  public static SimulationOptions asInFile() {
    return AS_IN_FILE;
  }

  /** Chooses the simulation among those of the file, by its name or its number, from 1. */
  public SimulationOptions simulation(String nameOrNumber) {
    return with(OPT_SIMULATION.value, nameOrNumber);
  }

  /**
   * Sets a parameter of the file; the model is generated with this value.
   *
   * @param value an expression, read in the unit that the file gives the parameter
   */
  public SimulationOptions parameter(String name, String value) {
    Map<String, String> more = new LinkedHashMap<>(parameters);
    more.put(name, value);
    return new SimulationOptions(texts, more, tunable, silenced);
  }

  /** Keeps a parameter as an input of the model, which may be set before a run. */
  public SimulationOptions tunable(String name) {
    Set<String> more = new LinkedHashSet<>(tunable);
    more.add(name);
    return new SimulationOptions(texts, parameters, more, silenced);
  }

  /** Silences a warning, of the model and of its runs, by its name or code. */
  public SimulationOptions silence(String warning) {
    Set<String> more = new LinkedHashSet<>(silenced);
    more.add(warning);
    return new SimulationOptions(texts, parameters, tunable, more);
  }

  /** Chooses the formulation: {@code auto}, {@code DTR}, {@code DSR}, {@code RR}, {@code RR-JF}. */
  public SimulationOptions formulation(String name) {
    return with(OPT_FORMULATION.value, name);
  }

  /**
   * Chooses the closure of loops: {@code auto}, {@code projection} or {@code penalty}, with
   * parameters {@code penalty:alpha=1e7,omega=10,mu=1}.
   */
  public SimulationOptions closure(String name) {
    return with(OPT_CLOSURE.value, name);
  }

  /** Builds the model from data instead of generated code. */
  public SimulationOptions compact() {
    return with(OPT_COMPACT.value, "true");
  }

  /**
   * Chooses the layout of generated code, which changes its size and speed but no result: {@code
   * auto}, {@code straight} (every operation written out) or {@code shared} (one method for bodies
   * that are alike).
   */
  public SimulationOptions code(String form) {
    return with(OPT_CODE.value, form);
  }

  /** Requests the sources in C instead of Java. */
  public SimulationOptions inC() {
    return with(SourceLanguage.OPTION, SourceLanguage.C.label());
  }

  /** Requests a part of a long text, from 0. */
  SimulationOptions textPart(int part) {
    return with(OPT_TEXT_PART.value, Integer.toString(part));
  }

  /** Requests another class of the model than that of its equations, from 1. */
  SimulationOptions sourcePart(int part) {
    return with(OPT_SOURCE_PART.value, Integer.toString(part));
  }

  /**
   * Chooses the integrator: {@code auto}, {@code ode113}, {@code DE}, {@code ode15s}, {@code
   * ode15sR}, or {@code switching}, which is ode113 and, while the motion is stiff, ode15s.
   */
  public SimulationOptions integrator(String name) {
    return with(OPT_INTEGRATOR.value, name);
  }

  /** Sets the local error allowed relative to the state. */
  public SimulationOptions relativeTolerance(double tolerance) {
    return with(OPT_REL_TOL.value, Double.toString(tolerance));
  }

  /** Sets the local error, in SI units, below which a state does not matter. */
  public SimulationOptions absoluteTolerance(double tolerance) {
    return with(OPT_ABS_TOL.value, Double.toString(tolerance));
  }

  /**
   * Sets the absolute tolerances, SI: one for all states, or four separated by semicolons, of
   * positions, angles, velocities and angular velocities.
   */
  public SimulationOptions absoluteTolerances(String tolerances) {
    return with(OPT_ABS_TOL.value, tolerances);
  }

  /**
   * Chooses the relation of the final error to the tolerances: {@code standard}, or {@code strict},
   * which makes errors smaller at the same tolerances and costs more evaluations.
   */
  public SimulationOptions accuracy(String name) {
    return with(Accuracy.OPTION, name);
  }

  /** Sets the end of the run, s. */
  public SimulationOptions endTime(double seconds) {
    return with(OPT_T_END.value, Double.toString(seconds));
  }

  /** Sets the distance of the result rows, s. */
  public SimulationOptions outputStep(double seconds) {
    return with(OPT_T_STEP.value, Double.toString(seconds));
  }

  /** Sets the column groups; time and the joints' positions and velocities always come first. */
  public SimulationOptions columns(Set<ColumnGroup> groups) {
    EnumSet<ColumnGroup> sorted = EnumSet.of(ColumnGroup.JOINTS);
    sorted.addAll(groups);
    if (sorted.size() == ColumnGroup.values().length) {
      return with(OPT_COLUMNS.value, ALL_COLUMNS);
    }
    return with(
        OPT_COLUMNS.value,
        sorted.stream().map(ColumnGroup::label).collect(Collectors.joining(",")));
  }

  /**
   * Treats warnings as errors: a warning about the model's file rejects it, and the first warning
   * of a run ends it.
   */
  public SimulationOptions strict() {
    return with(OPT_STRICT.value, "true");
  }

  boolean isStrict() {
    return "true".equals(texts.get(OPT_STRICT.value));
  }

  /**
   * Ends the run as failed (N-016) if its energy balance, the energy minus the work of forces,
   * drifts by more than this times the energy scale of the report.
   */
  public SimulationOptions maxDrift(double relative) {
    return with(OPT_MAX_DRIFT.value, Double.toString(relative));
  }

  /** Returns the bound on the drift; empty if there is none. The server has checked it. */
  OptionalDouble driftBound() {
    return texts.containsKey(OPT_MAX_DRIFT.value)
        ? OptionalDouble.of(Double.parseDouble(texts.get(OPT_MAX_DRIFT.value)))
        : OptionalDouble.empty();
  }

  /**
   * Asks for an analysis instead of the simulation that the file describes. Options of integration
   * do not apply to it and are left out.
   */
  SimulationOptions analysis(AnalysisKind kind) {
    Map<String, String> fitting = new LinkedHashMap<>(texts);
    fitting.keySet().removeAll(OF_INTEGRATION);
    if (kind == AnalysisKind.EQUILIBRIUM) {
      fitting.remove(OPT_T_END.value);
    }
    fitting.put(OPT_ANALYSIS.value, kind.label());
    SimulationOptions asked = new SimulationOptions(fitting, parameters, tunable, silenced);
    return kind.isLinear() ? asked.withOutputs() : asked;
  }

  /** Adds the outputs of the model's author to the columns, if the request names any. */
  private SimulationOptions withOutputs() {
    return columnGroups()
        .map(
            groups -> {
              EnumSet<ColumnGroup> more = EnumSet.copyOf(groups);
              more.add(ColumnGroup.OUTPUTS);
              return columns(more);
            })
        .orElse(this);
  }

  /** Builds the model for a run whose inputs are set from outside, also those with a table. */
  SimulationOptions inputsFromOutside() {
    return with(OPT_INPUTS.value, "outside");
  }

  /** Returns an option's text; empty if the file decides. */
  Optional<String> text(String key) {
    return Optional.ofNullable(texts.get(key));
  }

  /** Returns the options by their keys in the service's contract, without those of parameters. */
  public Map<String, String> texts() {
    return new LinkedHashMap<>(texts);
  }

  SimulationOptions standalone() {
    return with(OPT_STANDALONE.value, "true");
  }

  /** Sets an option by its key in the service's contract; for options this class does not name. */
  public SimulationOptions with(String key, String text) {
    Map<String, String> more = new LinkedHashMap<>(texts);
    more.put(key, text);
    return new SimulationOptions(more, parameters, tunable, silenced);
  }

  /** Returns the requested column groups; empty if the file decides. */
  public Optional<Set<ColumnGroup>> columnGroups() {
    return Optional.ofNullable(texts.get(OPT_COLUMNS.value))
        .map(
            labels ->
                labels.equals(ALL_COLUMNS)
                    ? EnumSet.allOf(ColumnGroup.class)
                    : ColumnGroup.of(labels));
  }

  NameValue[] toNameValues() {
    List<NameValue> options = new ArrayList<>();
    texts.forEach((key, text) -> options.add(new NameValue(key, text)));
    parameters.forEach(
        (name, value) -> options.add(new NameValue(OPT_SET.value, name + "=" + value)));
    tunable.forEach(name -> options.add(new NameValue(OPT_TUNABLE.value, name)));
    silenced.forEach(name -> options.add(new NameValue(OPT_SILENCE.value, name)));
    return options.toArray(NameValue[]::new);
  }

  @Override
  public String toString() {
    String all =
        Stream.of(toNameValues()).map(o -> o.key + "=" + o.text).collect(Collectors.joining(", "));
    return all.isEmpty() ? "as in file" : all;
  }
}
