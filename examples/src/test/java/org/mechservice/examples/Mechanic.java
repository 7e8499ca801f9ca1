package org.mechservice.examples;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.cli.Mech;

/**
 * Runs commands of {@code mech} in this process, each with an embedded server of its own. This is
 * much faster than starting a Java process for each of hundreds of models.
 */
final class Mechanic {
  /**
   * Result of a command.
   *
   * @param status its exit status
   * @param out what it printed on standard output
   * @param err what it printed on standard error
   */
  record Done(int status, String out, String err) {
    /** Returns this if the command was successful; fails the test with its messages if not. */
    Done orFail() {
      if (status != 0) {
        throw new AssertionError(toString());
      }
      return this;
    }
  }

  private Mechanic() {}

  /** Runs a command. */
  static Done mech(String... words) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int status = Mech.run(new PrintWriter(out), new PrintWriter(err), words);
    return new Done(status, out.toString(), err.toString());
  }

  /** Checks a model; classes of forces beside it are trusted. */
  static Done check(Path model) {
    return mech("check", model.toString(), "--user-code", folderOf(model), "--unconfined");
  }

  private static String folderOf(Path model) {
    return model.resolveSibling(".").normalize().toString();
  }

  /** Simulates a model, with its rows in a file; classes of forces beside it are trusted. */
  static Done simulate(Path model, Path rows, String... options) {
    List<String> words =
        new ArrayList<>(
            List.of(
                "simulate",
                model.toString(),
                "--user-code",
                folderOf(model),
                "--unconfined",
                "--out",
                rows.toString()));
    words.addAll(Arrays.asList(options));
    return mech(words.toArray(String[]::new));
  }
}
