package org.mechservice.cli.reference;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * A manual page in the language of man(7), as {@code man} shows it.
 *
 * <p>Source of the form: the manual page man-pages(7) of Linux.
 */
final class ManPage {
  private final StringBuilder page = new StringBuilder();

  private ManPage() {}

  /** Returns the file's name, such as {@code mech-admin-stop.1}. */
  static String fileName(CommandText command) {
    return title(command) + ".1";
  }

  private static String title(CommandText command) {
    return command.name().replace(' ', '-');
  }

  /**
   * Returns a page.
   *
   * @param version of the program
   * @param related other commands, whose pages it names
   */
  static String of(CommandText command, String version, List<CommandText> related) {
    return new ManPage().written(command, version, related);
  }

  private String written(CommandText command, String version, List<CommandText> related) {
    String title = title(command).toUpperCase(Locale.ROOT);
    line(".TH " + quoted(title) + " 1 \"\" " + quoted(version) + " " + quoted("MechService"));
    List<String> description = command.description();
    section("NAME");
    String does = description.get(0);
    line(
        text(title(command) + " - ")
            + text(
                does.substring(0, 1).toLowerCase(Locale.ROOT)
                    + does.substring(1).replaceAll("\\.$", "")));
    section("SYNOPSIS");
    line(".B " + text(command.usage()));
    section("DESCRIPTION");
    for (String paragraph : description) {
      line(".PP");
      line(text(paragraph));
    }
    entries("ARGUMENTS", command.arguments());
    entries("OPTIONS", command.options());
    if (!command.examples().isEmpty()) {
      section("EXAMPLES");
      for (String example : command.examples()) {
        line(".PP");
        line(".nf");
        line("    " + text(example));
        line(".fi");
      }
    }
    if (!command.statuses().isEmpty()) {
      section("EXIT STATUS");
      command.statuses().forEach((status, meaning) -> entry(status.strip(), meaning));
    }
    if (!related.isEmpty()) {
      section("SEE ALSO");
      line(
          related.stream()
              .map(other -> "\\fB" + text(title(other)) + "\\fR(1)")
              .collect(Collectors.joining(", ")));
    }
    return page.toString();
  }

  private void entries(String title, List<CommandText.Entry> entries) {
    if (!entries.isEmpty()) {
      section(title);
      entries.forEach(entry -> entry(entry.words(), entry.description()));
    }
  }

  private void entry(String words, String description) {
    line(".TP");
    line("\\fB" + text(words) + "\\fR");
    line(text(description.replace('\n', ' ')));
  }

  private void section(String title) {
    line(".SH " + quoted(title));
  }

  private void line(String line) {
    page.append(line).append('\n');
  }

  private static String quoted(String text) {
    return '"' + text(text) + '"';
  }

  /** Text as it is: no letters that mean something, and no line that begins like a request. */
  private static String text(String text) {
    String plain = text.replace("\\", "\\e").replace("-", "\\-");
    return plain.startsWith(".") || plain.startsWith("'") ? "\\&" + plain : plain;
  }
}
