package org.mechservice.examples;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Pages of the project that tell a user what to type. */
final class Documentation {
  private Documentation() {}

  /**
   * Returns the lines of a page's {@code sh} blocks, in order; a line ending in a backslash goes on
   * in the next one.
   *
   * @param page a Markdown file
   */
  static List<String> commandsOf(Path page) throws IOException {
    List<String> commands = new ArrayList<>();
    boolean inBlock = false;
    String begun = "";
    for (String line : Files.readAllLines(page)) {
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
