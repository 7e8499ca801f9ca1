package org.mechservice.cli.model;

import java.util.List;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.client.SimulationOptions;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Option;

/** The values that parameters of the file are set to. */
public final class ParameterOption {
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
  public SimulationOptions addTo(SimulationOptions options) {
    SimulationOptions all = options;
    List<String> names = assignments.stream().map(ParameterOption::nameIn).toList();
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
