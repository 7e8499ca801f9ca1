package org.mechservice.cli.shell;

import java.util.Arrays;
import picocli.CommandLine;
import picocli.CommandLine.Model.UsageMessageSpec;

/** Sections that the help of all commands shares. */
public final class HelpSections {
  private HelpSections() {}

  /**
   * Puts a heading over the examples of a command and of its subcommands, and gives each command
   * that has no exit statuses of its own those of the command above it.
   */
  public static void addTo(CommandLine command) {
    UsageMessageSpec usage = command.getCommandSpec().usageMessage();
    if (usage.footer().length > 0) {
      usage.footerHeading("%nExamples:%n");
      usage.footer(Arrays.stream(usage.footer()).map(line -> "  " + line).toArray(String[]::new));
    }
    for (CommandLine below : command.getSubcommands().values()) {
      UsageMessageSpec its = below.getCommandSpec().usageMessage();
      if (its.exitCodeList().isEmpty()) {
        its.exitCodeListHeading(usage.exitCodeListHeading());
        its.exitCodeList(usage.exitCodeList());
      }
      addTo(below);
    }
  }
}
