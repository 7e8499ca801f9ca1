package org.mechservice.cli.reference;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** The page {@code docs/reference/commands.md}: every command with all its options. */
final class CommandsPage {
  private static final String INTRODUCTION =
      """
      # Commands and options

      `mech help COMMAND` and `mech COMMAND --help` print the same on the terminal; `mech completion SHELL` makes the shell complete it. `./mech reference --page docs/reference/commands.md` has written this page from the program itself.

      Where an option says *the file's*, the model file decides, and [MechML](../mechml.md#simulations) has the defaults of what the file leaves open.

      """;

  private CommandsPage() {}

  /** Returns the page in Markdown. */
  static String of(List<CommandText> commands) {
    StringBuilder page = new StringBuilder(INTRODUCTION);
    page.append("| | |\n|---|---|\n");
    for (CommandText command : commands.subList(1, commands.size())) {
      if (command.name().split(" ", -1).length == 2) {
        page.append("| [`").append(command.name()).append("`](#");
        page.append(command.name().replace(' ', '-')).append(") | ");
        page.append(cell(command.description().get(0))).append(" |\n");
      }
    }
    CommandText root = commands.get(0);
    page.append("\n## Exit status\n\n| | |\n|---|---|\n");
    statuses(page, root.statuses());
    commands.stream().skip(1).forEach(command -> section(page, command, root.statuses()));
    return page.toString();
  }

  private static void section(
      StringBuilder page, CommandText command, Map<String, String> usualStatuses) {
    page.append("\n## ").append(command.name()).append("\n\n");
    command.description().forEach(line -> page.append(escaped(line)).append("\n\n"));
    page.append("```\n").append(command.usage()).append("\n```\n");
    if (!command.examples().isEmpty()) {
      page.append("\nExamples:\n\n```\n");
      command.examples().forEach(line -> page.append(line).append('\n'));
      page.append("```\n");
    }
    entries(page, command.arguments());
    // Every command has these two.
    entries(
        page,
        command.options().stream()
            .filter(option -> !option.words().equals("-h, --help"))
            .filter(option -> !option.words().equals("-V, --version"))
            .toList());
    if (!command.statuses().equals(usualStatuses) && !command.statuses().isEmpty()) {
      page.append("\n| exit status | |\n|---|---|\n");
      statuses(page, new TreeMap<>(command.statuses()));
    }
  }

  private static void entries(StringBuilder page, List<CommandText.Entry> entries) {
    if (!entries.isEmpty()) {
      page.append("\n| | |\n|---|---|\n");
      for (CommandText.Entry entry : entries) {
        page.append("| `").append(entry.words().replace("|", "\\|")).append("` | ");
        page.append(cell(entry.description())).append(" |\n");
      }
    }
  }

  private static void statuses(StringBuilder page, Map<String, String> statuses) {
    statuses.forEach(
        (status, meaning) ->
            page.append("| ").append(status).append(" | ").append(cell(meaning)).append(" |\n"));
  }

  private static String cell(String text) {
    return escaped(text).replace("|", "\\|").replace('\n', ' ');
  }

  private static String escaped(String text) {
    return text.replace("*", "\\*").replace("<", "&lt;").replace("_", "\\_");
  }
}
