package org.mechservice.sim.model;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import org.mechservice.sim.compile.SolverClasses;

/**
 * The runtime JAR as the build has packed it, which takes longer than a small simulation. With it
 * goes a list: the fingerprint of the solver's files it was made from, and the classes in it. A
 * solver that was compiled since has another fingerprint; then the JAR is not used.
 */
public final class BuiltRuntime {
  private static final String JAR = "runtime.jar";
  private static final String LIST = "runtime.list";

  private BuiltRuntime() {}

  /** Returns the JAR if it belongs to the solver of this process. */
  static Optional<RuntimeJar> find() {
    try (InputStream jar = BuiltRuntime.class.getResourceAsStream(JAR);
        InputStream list = BuiltRuntime.class.getResourceAsStream(LIST)) {
      if (jar == null || list == null) {
        return Optional.empty();
      }
      List<String> lines = new String(list.readAllBytes(), StandardCharsets.UTF_8).lines().toList();
      return lines.isEmpty() || !lines.get(0).equals(SolverClasses.fingerprint())
          ? Optional.empty()
          : Optional.of(
              RuntimeJar.of(jar.readAllBytes(), new HashSet<>(lines.subList(1, lines.size()))));
    } catch (IOException e) {
      throw new UncheckedIOException("the runtime JAR of the build cannot be read", e);
    }
  }

  /**
   * Packs the runtime JAR, if what is there is of another solver; called by the build.
   *
   * @param arguments the folder of this module's classes
   */
  public static void main(String[] arguments) {
    if (find().isPresent()) {
      return;
    }
    Path folder =
        Path.of(arguments[0]).resolve(BuiltRuntime.class.getPackageName().replace('.', '/'));
    RuntimeJar made = RuntimeJar.pack();
    List<String> lines = new ArrayList<>(made.classes());
    Collections.sort(lines);
    lines.add(0, SolverClasses.fingerprint());
    try {
      Files.createDirectories(folder);
      Files.write(folder.resolve(JAR), made.jar().bytes());
      Files.write(folder.resolve(LIST), lines);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
