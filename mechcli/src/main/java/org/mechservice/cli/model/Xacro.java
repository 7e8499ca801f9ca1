package org.mechservice.cli.model;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Robots with the macros of xacro, which the program {@code xacro} of ROS or PyPI expands. It
 * evaluates expressions of the file, so it runs when the user asks for an import of that file, not
 * where a library or a server reads one. Source: wiki.ros.org/xacro.
 */
final class Xacro {
  /** What a file with macros has: an element of their name space. */
  private static final String MACRO = "<xacro:";

  private Xacro() {}

  /**
   * Returns the robot that a file with macros stands for; empty if it has none, or if there is no
   * program {@code xacro}.
   *
   * @param values of the file's arguments, as NAME:=VALUE
   * @throws UsageException if the program refuses the file, or if there are values for a file
   *     without macros
   */
  static Optional<byte[]> expanded(Path file, List<String> values) throws IOException {
    return expanded("xacro", file, values);
  }

  /** As above, with a program of another name. */
  static Optional<byte[]> expanded(String program, Path file, List<String> values)
      throws IOException {
    if (!hasMacros(file)) {
      refuse(file.toString(), values, "it has no macros of xacro");
      return Optional.empty();
    }
    List<String> command = new ArrayList<>(List.of(program, file.toString()));
    command.addAll(values);
    Path said = Files.createTempFile("xacro", ".txt");
    try {
      Process process;
      try {
        process = new ProcessBuilder(command).redirectError(said.toFile()).start();
      } catch (IOException e) {
        return Optional.empty();
      }
      process.getOutputStream().close();
      byte[] robot;
      try (InputStream out = process.getInputStream()) {
        robot = out.readAllBytes();
      }
      if (process.waitFor() != 0) {
        throw new UsageException(
            MessageCode.NOT_A_ROBOT
                + " "
                + file
                + ": xacro refuses it: "
                + Files.readString(said, StandardCharsets.UTF_8).strip().replace('\n', ' '));
      }
      return Optional.of(robot);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted while xacro runs", e);
    } finally {
      Files.delete(said);
    }
  }

  /**
   * Refuses values that nothing reads.
   *
   * @param robot what is imported
   * @param why why nothing reads them
   * @throws UsageException if there are any
   */
  static void refuse(String robot, List<String> values, String why) {
    if (!values.isEmpty()) {
      throw new UsageException(
          MessageCode.NOT_A_ROBOT
              + " "
              + robot
              + ": --xacro "
              + values.get(0)
              + " has no meaning: "
              + why
              + "; leave it out");
    }
  }

  private static boolean hasMacros(Path file) throws IOException {
    return new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1).contains(MACRO);
  }
}
