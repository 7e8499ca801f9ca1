package org.mechservice.cli.model;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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
    for (Map.Entry<String, String> assignment : values().entrySet()) {
      all = all.parameter(assignment.getKey(), assignment.getValue());
    }
    return all;
  }

  /**
   * Returns the values by the names of their parameters, in the order of the options.
   *
   * @throws UsageException if an assignment is none, or a parameter is set twice
   */
  public Map<String, String> values() {
    Map<String, String> values = new LinkedHashMap<>();
    for (String assignment : assignments) {
      String name = nameIn(assignment);
      String value = assignment.substring(assignment.indexOf('=') + 1).strip();
      if (values.put(name, value) != null) {
        throw new UsageException(
            MessageCode.OPTION_UNUSABLE + " --set names parameter \"" + name + "\" twice");
      }
    }
    return values;
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
