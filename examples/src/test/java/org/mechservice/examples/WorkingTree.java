package org.mechservice.examples;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;

/** The checked-out project the tests run in. */
final class WorkingTree {
  /** Its top-level directory. */
  static final Path TOP = findTop();

  /** The paper's five-bar pendulum. */
  static final Path PENDULUM = TOP.resolve("examples/pendulum/pendulum.xml");

  private WorkingTree() {}

  private static Path findTop() {
    Path directory = Path.of("").toAbsolutePath();
    while (!Files.exists(directory.resolve("idl/src/main/idl/mechservice.idl"))) {
      Path parent = directory.getParent();
      if (parent == null) {
        throw new IllegalStateException("not started inside the project's directory");
      }
      directory = parent;
    }
    return directory;
  }

  /**
   * Makes a directory look like the top level to a user's commands, so that files they write do not
   * end up among the sources.
   *
   * @param directory an empty directory
   */
  static void mirrorIn(Path directory) throws IOException {
    Files.createSymbolicLink(directory.resolve("examples"), TOP.resolve("examples"));
    Path launcher = directory.resolve("mech");
    Files.writeString(launcher, "#!/bin/sh\nexec '" + TOP.resolve("mech") + "' \"$@\"\n");
    Files.setPosixFilePermissions(launcher, PosixFilePermissions.fromString("rwxr-xr-x"));
  }
}
