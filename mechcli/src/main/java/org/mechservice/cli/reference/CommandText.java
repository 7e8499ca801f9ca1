package org.mechservice.cli.reference;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/**
 * The reference text of one command.
 *
 * @param name its words, such as {@code mech admin stop}
 * @param usage how it is called
 * @param description paragraphs; the first says what the command does
 * @param arguments its positional arguments
 * @param options its options, by name
 * @param examples command lines
 * @param statuses what its exit statuses mean
 */
record CommandText(
    String name,
    String usage,
    List<String> description,
    List<Entry> arguments,
    List<Entry> options,
    List<String> examples,
    Map<String, String> statuses) {
  /**
   * One argument or option.
   *
   * @param words its names and the word for its value
   * @param description what it does
   */
  record Entry(String words, String description) {}

  /** Returns the texts of a command and of all below it that help lists, without those of help. */
  static List<CommandText> ofAll(CommandLine root) {
    List<CommandText> all = new ArrayList<>();
    add(root, all);
    return List.copyOf(all);
  }

  private static void add(CommandLine command, List<CommandText> all) {
    all.add(of(command));
    command.getSubcommands().values().stream()
        .filter(below -> !below.getCommandSpec().usageMessage().hidden())
        .filter(below -> !below.getCommandName().equals("help"))
        .forEach(below -> add(below, all));
  }

  private static CommandText of(CommandLine command) {
    UsageMessageSpec help = command.getCommandSpec().usageMessage();
    List<OptionSpec> options =
        command.getCommandSpec().options().stream().filter(option -> !option.hidden()).toList();
    List<? extends ArgSpec> arguments =
        command.getCommandSpec().positionalParameters().stream()
            .filter(argument -> !argument.hidden())
            .toList();
    String name = command.getCommandSpec().qualifiedName();
    return new CommandText(
        name,
        usage(command, name, options, arguments),
        Arrays.stream(help.description()).flatMap(part -> plain(part).lines()).toList(),
        arguments.stream()
            .map(argument -> new Entry(word(argument), text(argument.description())))
            .toList(),
        options.stream()
            .sorted(Comparator.comparing(OptionSpec::longestName))
            .map(option -> new Entry(words(option), text(option.description())))
            .toList(),
        Arrays.stream(help.footer()).map(line -> plain(line).strip()).toList(),
        new LinkedHashMap<>(help.exitCodeList()));
  }

  private static String usage(
      CommandLine command,
      String name,
      List<OptionSpec> options,
      List<? extends ArgSpec> arguments) {
    StringBuilder usage = new StringBuilder(name);
    options.stream()
        .filter(ArgSpec::required)
        .forEach(option -> usage.append(' ').append(option.shortestName()).append(value(option)));
    usage.append(" [OPTIONS]");
    arguments.forEach(argument -> usage.append(' ').append(word(argument)));
    if (!command.getSubcommands().isEmpty()) {
      boolean needed = command.getCommandSpec().positionalParameters().isEmpty();
      usage.append(needed ? " COMMAND" : " [COMMAND]");
    }
    return usage.toString();
  }

  private static String word(ArgSpec argument) {
    String word = argument.paramLabel() + (argument.arity().max() > 1 ? "..." : "");
    return argument.arity().min() == 0 ? "[" + word + "]" : word;
  }

  private static String words(OptionSpec option) {
    return Arrays.stream(option.names()).collect(Collectors.joining(", ")) + value(option);
  }

  private static String value(OptionSpec option) {
    String label = option.paramLabel() + (option.arity().max() > 2 ? "..." : "");
    if (option.arity().max() == 0) {
      return "";
    }
    return option.arity().min() == 0 ? "[=" + label + "]" : "=" + label;
  }

  private static String text(String[] description) {
    return Arrays.stream(description).map(CommandText::plain).collect(Collectors.joining(" "));
  }

  /** Picocli's texts are formats. */
  private static String plain(String text) {
    return text.replace("%n", "\n").replace("%%", "%");
  }
}
