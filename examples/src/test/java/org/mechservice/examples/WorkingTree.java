package org.mechservice.examples;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.List;

/** The checked-out project the tests run in. */
final class WorkingTree {
  /** Its top-level directory. */
  static final Path TOP = findTop();

  /** The launcher. */
  static final Path MECH = launcher();

  /** The paper's five-bar pendulum. */
  static final Path PENDULUM = TOP.resolve("examples/pendulum/pendulum.xml");

  /** What commands read: scenes, and the solver for programs of a user's own. */
  private static final List<String> MIRRORED = List.of("examples", "solver-core");

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
   * Returns the launcher. It builds what is older than its sources; a running build that has just
   * packaged everything, or found it unchanged, must not start another one in its own place.
   */
  private static Path launcher() {
    Path packaged = TOP.resolve("mechcli/target/mechcli.jar");
    if (Boolean.getBoolean("mech.packaged") && Files.exists(packaged)) {
      try {
        Files.setLastModifiedTime(packaged, FileTime.from(Instant.now()));
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
    return TOP.resolve("mech");
  }

  /**
   * Makes a directory look like the top level to a user's commands, so that files they write do not
   * end up among the sources.
   *
   * @param directory an empty directory
   */
  static void mirrorIn(Path directory) throws IOException {
    for (String part : MIRRORED) {
      Files.createSymbolicLink(directory.resolve(part), TOP.resolve(part));
    }
    Path launcher = directory.resolve("mech");
    Files.writeString(launcher, "#!/bin/sh\nexec '" + MECH + "' \"$@\"\n");
    Files.setPosixFilePermissions(launcher, PosixFilePermissions.fromString("rwxr-xr-x"));
  }

  /** Takes the links away again. */
  static void unmirror(Path directory) throws IOException {
    for (String part : MIRRORED) {
      Files.deleteIfExists(directory.resolve(part));
    }
  }
}
