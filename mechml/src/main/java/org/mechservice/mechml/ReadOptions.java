package org.mechservice.mechml;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.solver.catalogue.AnalysisKind;

/**
 * Options for reading a model file: the simulation to choose and the parameters to set.
 *
 * @param simulation name or number, from 1, of the chosen {@code MBSsimulation}; empty for the
 *     first
 * @param values new values of parameters: name and expression, in the unit that the file gives the
 *     parameter
 * @param tunable names of parameters that stay inputs of the model, besides those marked in the
 *     file
 * @param inputs what becomes of inputs
 * @param analysis what is computed instead of the chosen simulation; empty for the simulation
 * @param silenced names or codes of warnings that are not given, besides those of the file
 */
public record ReadOptions(
    Optional<String> simulation,
    Map<String, String> values,
    Set<String> tunable,
    Inputs inputs,
    Optional<AnalysisKind> analysis,
    Set<String> silenced) {
  /** Default options: the first simulation, all parameters as in the file. */
  public static final ReadOptions NONE = new ReadOptions(Optional.empty(), Map.of(), Set.of());

  public ReadOptions {
    values = Map.copyOf(values);
    tunable = Set.copyOf(tunable);
    silenced = Set.copyOf(silenced);
  }

  /** Creates options for a run without inputs from outside. */
  public ReadOptions(Optional<String> simulation, Map<String, String> values, Set<String> tunable) {
    this(simulation, values, tunable, Inputs.AS_IN_FILE, Optional.empty(), Set.of());
  }

  /** The treatment of the inputs of a model. */
  public enum Inputs {
    /** Those with a table follow it, the others are states that keep their start values. */
    AS_IN_FILE,
    /** All are states that are set during the run. */
    STATES,
    /** All are parameters behind the tunable ones, for models that leave this program. */
    PARAMETERS
  }

  /** Returns the same options for a run whose inputs are set from outside. */
  public ReadOptions withInputsFromOutside() {
    return new ReadOptions(simulation, values, tunable, Inputs.STATES, analysis, silenced);
  }

  /** Returns the same options for a model whose inputs are parameters behind the tunable ones. */
  public ReadOptions withInputsAsParameters() {
    return new ReadOptions(simulation, values, tunable, Inputs.PARAMETERS, analysis, silenced);
  }

  /** Returns the same options for an analysis in place of the chosen simulation. */
  public ReadOptions withAnalysis(AnalysisKind kind) {
    return new ReadOptions(simulation, values, tunable, inputs, Optional.of(kind), silenced);
  }

  /** Returns the same options with other values of parameters. */
  public ReadOptions with(Map<String, String> other) {
    return new ReadOptions(simulation, other, tunable, inputs, analysis, silenced);
  }

  /** Returns the same options with other parameters that stay inputs. */
  public ReadOptions withTunable(Set<String> names) {
    return new ReadOptions(simulation, values, names, inputs, analysis, silenced);
  }

  /** Returns the same options with another simulation chosen, by its name or number. */
  public ReadOptions withSimulation(String nameOrNumber) {
    return new ReadOptions(Optional.of(nameOrNumber), values, tunable, inputs, analysis, silenced);
  }

  /**
   * Returns the same options without some warnings.
   *
   * @param warnings names or codes
   */
  public ReadOptions silencing(Set<String> warnings) {
    return new ReadOptions(simulation, values, tunable, inputs, analysis, warnings);
  }

  /** Returns options that set parameters. */
  public static ReadOptions setting(Map<String, String> values) {
    return new ReadOptions(Optional.empty(), values, Set.of());
  }

  /** Returns options that choose a simulation. */
  public static ReadOptions choosing(String simulation) {
    return new ReadOptions(Optional.of(simulation), Map.of(), Set.of());
  }
}
