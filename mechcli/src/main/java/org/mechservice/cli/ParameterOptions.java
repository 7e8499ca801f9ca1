package org.mechservice.cli;

import java.util.List;
import org.mechservice.client.SimulationOptions;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Which simulation of a file is meant, and what its parameters are set to. */
final class ParameterOptions {
  @Mixin private SimulationChoice choice = new SimulationChoice();

  @Option(
      names = "--set",
      paramLabel = "PARAMETER=VALUE",
      description =
          "Value of a parameter, in its unit, instead of the file's; may be given several times.")
  private List<String> assignments = List.of();

  /**
   * Returns the options given with these added.
   *
   * @throws UsageException if an assignment is none, or a parameter is set twice
   */
  SimulationOptions addTo(SimulationOptions options) {
    SimulationOptions all = choice.addTo(options);
    List<String> names = assignments.stream().map(ParameterOptions::nameIn).toList();
    for (int i = 0; i < names.size(); i++) {
      String name = names.get(i);
      if (names.indexOf(name) < i) {
        throw new UsageException(
            MessageCode.OPTION_UNUSABLE + " --set names parameter \"" + name + "\" twice");
      }
      String assignment = assignments.get(i);
      all = all.parameter(name, assignment.substring(assignment.indexOf('=') + 1).strip());
    }
    return all;
  }

  private static String nameIn(String assignment) {
    int equals = assignment.indexOf('=');
    if (equals < 1) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " --set takes PARAMETER=VALUE, such as --set length=0.5, not \""
              + assignment
              + "\"");
    }
    return assignment.substring(0, equals).strip();
  }
}
