package org.mechservice.examples;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Reads the commands in the project's Markdown pages. */
final class Documentation {
  private Documentation() {}

  /**
   * Returns the lines of a page's {@code sh} blocks, in order; a line ending in a backslash goes on
   * in the next one.
   *
   * @param page a Markdown file
   */
  static List<String> commandsOf(Path page) throws IOException {
    return commandsIn(Files.readAllLines(page));
  }

  /** Returns the lines of a page's section, of second level. */
  static List<String> section(Path page, String title) throws IOException {
    List<String> lines = Files.readAllLines(page);
    int start = lines.indexOf("## " + title) + 1;
    if (start == 0) {
      throw new AssertionError(page + " has no section \"" + title + "\"");
    }
    int end = start;
    while (end < lines.size() && !lines.get(end).startsWith("## ")) {
      end++;
    }
    return lines.subList(start, end);
  }

  /** Returns the commands in the {@code sh} blocks of some lines, like {@link #commandsOf}. */
  static List<String> commandsIn(List<String> lines) {
    List<String> commands = new ArrayList<>();
    boolean inBlock = false;
    String begun = "";
    for (String line : lines) {
      if (line.startsWith("```")) {
        inBlock = !inBlock && line.equals("```sh");
      } else if (inBlock && line.endsWith("\\")) {
        begun += line.substring(0, line.length() - 1);
      } else if (inBlock && !line.isBlank()) {
        commands.add(begun + line);
        begun = "";
      }
    }
    return commands;
  }
}
