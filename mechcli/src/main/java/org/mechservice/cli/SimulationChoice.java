package org.mechservice.cli;

import java.util.List;
import org.mechservice.client.SimulationOptions;
import picocli.CommandLine.Option;

/** Which simulation of a file is meant, and which of its parameters stay inputs. */
final class SimulationChoice {
  @Option(
      names = "--simulation",
      paramLabel = "NAME|N",
      description = "Simulation of the file, by name or number; without it the first.")
  private String simulation = "";

  @Option(
      names = "--tunable",
      paramLabel = "PARAMETER",
      description =
          "Keep a parameter as an input that may be set before a run; may be given several times.")
  private List<String> tunable = List.of();

  /** Returns the options given with these added. */
  SimulationOptions addTo(SimulationOptions options) {
    SimulationOptions all = simulation.isEmpty() ? options : options.simulation(simulation);
    for (String name : tunable) {
      all = all.tunable(name.strip());
    }
    return all;
  }
}
