package org.mechservice.cli.model;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.mechservice.client.SimulationOptions;
import org.mechservice.mechml.ReadOptions;
import picocli.CommandLine.Option;

/** The warnings that a command does not give. */
public final class SilenceOption {
  @Option(
      names = "--silence",
      split = ",",
      paramLabel = "WARNING",
      hideParamSyntax = true,
      description =
          "Warnings that are not given, by name or code, separated by commas, besides those that"
              + " the file silences, such as no-gravity or M-090.")
  private List<String> warnings = List.of();

  /** Returns the options given with these added. */
  public SimulationOptions addTo(SimulationOptions options) {
    SimulationOptions all = options;
    for (String warning : warnings) {
      all = all.silence(warning.strip());
    }
    return all;
  }

  /** Returns the options given with these added. */
  ReadOptions addTo(ReadOptions options) {
    Set<String> all = new LinkedHashSet<>(options.silenced());
    warnings.forEach(warning -> all.add(warning.strip()));
    return options.silencing(all);
  }
}
