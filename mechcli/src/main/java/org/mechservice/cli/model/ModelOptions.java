package org.mechservice.cli.model;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.client.SimulationOptions;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.SimulationSettings;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/**
 * Options of every command that builds a model: which simulation of the file, which parameters stay
 * inputs, the method, and the columns of the results.
 */
public final class ModelOptions {
  @Mixin private MethodOptions method = new MethodOptions();

  @Option(
      names = "--tunable",
      paramLabel = "PARAMETER",
      description =
          "Keep a parameter as an input that may be set before a run; may be given several times.")
  private List<String> tunable = List.of();

  @Mixin private SilenceOption silence = new SilenceOption();

  /** Returns whether another simulation of the file than the first may be meant. */
  public boolean choosesSimulation() {
    return method.simulation().isPresent();
  }

  /**
   * Returns how a model file is to be read here, without a server.
   *
   * @param values values of parameters, by name
   */
  public ReadOptions reading(Map<String, String> values) {
    Set<String> names = tunable.stream().map(String::strip).collect(Collectors.toSet());
    return silence.addTo(new ReadOptions(method.simulation(), values, names));
  }

  /** Returns the settings of a simulation with those that are given here. */
  SimulationSettings addTo(SimulationSettings settings) {
    return method.addTo(settings);
  }

  /** Returns the closure given; empty if none is. */
  String closure() {
    return method.closure();
  }

  /** Returns the options given with these added. */
  public SimulationOptions addTo(SimulationOptions options) {
    SimulationOptions all = silence.addTo(method.addTo(options));
    for (String name : tunable) {
      all = all.tunable(name.strip());
    }
    return all;
  }
}
