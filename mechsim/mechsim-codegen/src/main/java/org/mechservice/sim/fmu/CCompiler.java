package org.mechservice.sim.fmu;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * A C compiler of this machine: {@code cc}, {@code gcc} or {@code clang} for the machine itself,
 * {@code zig} (or {@code python-zig}) for every platform.
 */
final class CCompiler {
  /** The first build for another platform compiles that platform's C library. */
  private static final long MINUTES = 15;

  private static final List<String> OPTIONS =
      List.of("-std=c99", "-O2", "-ffp-contract=off", "-fvisibility=hidden", "-shared");

  /** Options of a WebAssembly module: no C library, no imports, a stack of 1 MB. */
  private static final List<String> MODULE_OPTIONS =
      List.of(
          "-std=c99",
          "-O2",
          "-ffp-contract=off",
          "-fno-math-errno",
          "-nostdlib",
          "-nostdlibinc",
          "-mbulk-memory",
          "-I.",
          "-Wl,--no-entry",
          "-Wl,-z,stack-size=1048576",
          "-Wl,--strip-all");

  private final List<String> command;
  private final List<String> options;
  private final List<String> libraries;

  private CCompiler(List<String> command, List<String> options, List<String> libraries) {
    this.command = command;
    this.options = options;
    this.libraries = libraries;
  }

  private static CCompiler ofUnits(List<String> command, FmuPlatform platform) {
    if (platform == FmuPlatform.WIN64) {
      return new CCompiler(command, OPTIONS, List.of());
    }
    List<String> options = new ArrayList<>(OPTIONS);
    options.add("-fPIC");
    return new CCompiler(command, options, List.of("-lm"));
  }

  /** Returns a compiler for WebAssembly: clang with lld, or zig; empty if this machine has none. */
  static Optional<CCompiler> forWebAssembly() {
    Optional<Path> clang = onPath("clang");
    if (clang.isPresent() && onPath("wasm-ld").isPresent()) {
      return Optional.of(
          new CCompiler(
              List.of(clang.get().toString(), "--target=wasm32"), MODULE_OPTIONS, List.of()));
    }
    return zig()
        .map(
            zig ->
                new CCompiler(
                    List.of(zig.toString(), "cc", "-target", "wasm32-freestanding"),
                    MODULE_OPTIONS,
                    List.of()));
  }

  /** Returns a compiler for a platform; empty if this machine has none. */
  static Optional<CCompiler> forPlatform(FmuPlatform platform) {
    if (FmuPlatform.ofThisMachine().equals(Optional.of(platform))) {
      for (String name : List.of("cc", "gcc", "clang")) {
        Optional<Path> found = onPath(name);
        if (found.isPresent()) {
          return Optional.of(ofUnits(List.of(found.get().toString()), platform));
        }
      }
    }
    return zig()
        .map(
            zig ->
                ofUnits(
                    List.of(zig.toString(), "cc", "-target", platform.zigTarget(), "-s"),
                    platform));
  }

  /** Returns zig itself, or the command that its Python package installs. */
  private static Optional<Path> zig() {
    return onPath("zig").or(() -> onPath("python-zig"));
  }

  private static Optional<Path> onPath(String name) {
    Map<String, String> environment = System.getenv();
    String path = environment.getOrDefault("PATH", environment.getOrDefault("Path", ""));
    return Stream.of(path.split(File.pathSeparator, -1))
        .filter(folder -> !folder.isEmpty())
        .flatMap(folder -> Stream.of(new File(folder, name), new File(folder, name + ".exe")))
        .filter(file -> file.isFile() && file.canExecute())
        .map(File::toPath)
        .findFirst();
  }

  /**
   * Compiles a shared library or a module.
   *
   * @param files sources and headers by name
   * @throws IOException if it cannot be done; the message has the compiler's words
   */
  byte[] compile(SortedMap<String, String> files) throws IOException {
    Path folder = Files.createTempDirectory("mech-fmu");
    try {
      for (Map.Entry<String, String> file : files.entrySet()) {
        Files.writeString(folder.resolve(file.getKey()), file.getValue());
      }
      Path library = folder.resolve("library.bin");
      List<String> words = new ArrayList<>(command);
      words.addAll(options);
      words.add("-o");
      words.add(library.getFileName().toString());
      words.addAll(FmuSources.compiled(files));
      words.addAll(libraries);
      run(words, folder);
      return Files.readAllBytes(library);
    } finally {
      delete(folder);
    }
  }

  private static void run(List<String> words, Path folder) throws IOException {
    Path said = folder.resolve("compiler.txt");
    Process process =
        new ProcessBuilder(words)
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectOutput(said.toFile())
            .start();
    try {
      if (!process.waitFor(MINUTES, TimeUnit.MINUTES)) {
        process.destroyForcibly();
        throw new IOException("the C compiler " + words.get(0) + " did not end");
      }
    } catch (InterruptedException e) {
      process.destroyForcibly();
      Thread.currentThread().interrupt();
      throw new IOException("told to stop while the C compiler ran", e);
    }
    if (process.exitValue() != 0) {
      String text = new String(Files.readAllBytes(said), StandardCharsets.UTF_8);
      throw new IOException(
          "the C compiler "
              + words.get(0)
              + " failed: "
              + text.substring(0, Math.min(text.length(), 2000)).strip());
    }
  }

  private static void delete(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      for (Path file : files.toList()) {
        Files.deleteIfExists(file);
      }
    }
    Files.deleteIfExists(folder);
  }
}
