package org.mechservice.cli.shell;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/**
 * Completions for the shell fish: one {@code complete} line for each command and each option, with
 * its description.
 *
 * <p>A line holds where all names of its command are among the words typed so far.
 */
final class FishCompletion {
  private final StringBuilder script = new StringBuilder();

  private FishCompletion() {}

  /** Returns the script that completes a command with all its subcommands. */
  static String of(CommandLine root) {
    FishCompletion completion = new FishCompletion();
    completion.add(root.getCommandName(), List.of(), root);
    return completion.script.toString();
  }

  private void add(String program, List<String> path, CommandLine command) {
    Map<String, CommandLine> shown = new LinkedHashMap<>(command.getSubcommands());
    shown.values().removeIf(each -> each.getCommandSpec().usageMessage().hidden());
    List<String> names = List.copyOf(shown.keySet());
    String start = "complete -c " + program + " -n " + quoted(condition(path, names));
    shown.forEach(
        (name, subcommand) -> {
          String what = summary(subcommand.getCommandSpec().usageMessage().description());
          script.append(start).append(" -f -a ").append(name).append(what).append('\n');
        });
    for (OptionSpec option : command.getCommandSpec().options()) {
      if (!option.hidden()) {
        script.append(start).append(words(option)).append(summary(option.description()));
        script.append('\n');
      }
    }
    shown.forEach(
        (name, subcommand) -> {
          List<String> deeper = new ArrayList<>(path);
          deeper.add(name);
          add(program, deeper, subcommand);
        });
  }

  private static String condition(List<String> path, List<String> names) {
    List<String> terms = new ArrayList<>();
    path.forEach(name -> terms.add("__fish_seen_subcommand_from " + name));
    if (!names.isEmpty()) {
      terms.add("not __fish_seen_subcommand_from " + String.join(" ", names));
    }
    return terms.isEmpty() ? "true" : String.join("; and ", terms);
  }

  private static String words(OptionSpec option) {
    StringBuilder words = new StringBuilder();
    for (String name : option.names()) {
      if (name.startsWith("--")) {
        words.append(" -l ").append(name.substring(2));
      } else {
        words.append(name.length() == 2 ? " -s " : " -o ").append(name.substring(1));
      }
    }
    if (option.arity().max() > 0) {
      Iterable<String> candidates = option.completionCandidates();
      if (candidates == null) {
        words.append(" -r");
      } else {
        words.append(" -x -a ").append(quoted(String.join(" ", candidates)));
      }
    }
    return words.toString();
  }

  /** Returns the first sentence of a description as fish takes it. */
  private static String summary(String[] description) {
    if (description.length == 0) {
      return "";
    }
    String text = description[0].replace("%n", "\n").replace("%%", "%");
    text = text.lines().findFirst().orElse("");
    int end = text.indexOf(". ");
    return " -d " + quoted(end < 0 ? text : text.substring(0, end + 1));
  }

  private static String quoted(String text) {
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'";
  }
}
