package org.mechservice.sim.emit.c;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * C files of a test: compiled with all warnings as errors by the C compiler of the machine, and run
 * with numbers on their standard input and output. Tests skip on a machine without one.
 */
final class CCode {
  private static final List<String> OPTIONS =
      List.of("-std=c99", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off");

  /** Optimised, as users compile. */
  static final List<String> FAST = List.of("-O2");

  /** Compiled quickly, for many programs that run briefly. */
  static final List<String> PLAIN = List.of("-O0");

  /** Undefined behaviour and accesses outside arrays end the program. */
  static final List<String> CHECKED =
      List.of("-O1", "-fsanitize=address,undefined", "-fno-sanitize-recover=all");

  private CCode() {}

  /** Returns the compiler's path; skips the test if there is none. */
  static String compiler() {
    String path = System.getenv().getOrDefault("PATH", "");
    String found =
        Stream.of("cc", "gcc", "clang")
            .flatMap(
                name -> Stream.of(path.split(File.pathSeparator, -1)).map(p -> new File(p, name)))
            .filter(File::canExecute)
            .map(File::getPath)
            .findFirst()
            .orElse("");
    assumeTrue(!found.isEmpty(), "this machine has no C compiler (cc, gcc or clang)");
    return found;
  }

  /** Returns whether programs with the sanitizers of {@link #CHECKED} can be made here. */
  static boolean hasSanitizers(Path folder) throws IOException {
    Path source = folder.resolve("empty.c");
    Files.writeString(source, "int main(void) { return 0; }\n");
    Path program = folder.resolve("empty");
    return ended(folder, command(CHECKED, program, List.of(source)), new byte[0]).status() == 0
        && ended(folder, List.of(program.toString()), new byte[0]).status() == 0;
  }

  /** Writes a file of the main resources of this package. */
  static Path resource(Path folder, String name) throws IOException {
    Path file = folder.resolve(name);
    try (InputStream in = CCode.class.getResourceAsStream(name)) {
      assertThat(in).as(name).isNotNull();
      Files.write(file, in.readAllBytes());
    }
    return file;
  }

  /**
   * Compiles a model with a program that calls it.
   *
   * @param place folder for the sources and the program
   * @param driver the program's text
   * @return the program
   */
  static Path compiled(CModel model, Path place, List<String> options, String driver)
      throws IOException {
    List<Path> sources = new ArrayList<>();
    for (Map.Entry<String, String> file : model.files().entrySet()) {
      Path path = place.resolve(file.getKey());
      Files.writeString(path, file.getValue());
      if (file.getKey().endsWith(".c") && !file.getKey().equals("example.c")) {
        sources.add(path);
      }
    }
    sources.add(Files.writeString(place.resolve("driver.c"), driver));
    return compiled(place, options, sources);
  }

  /** Compiles sources to a program and returns it. */
  static Path compiled(Path folder, List<String> options, List<Path> sources) throws IOException {
    Path program = folder.resolve("program");
    Ended ended = ended(folder, command(options, program, sources), new byte[0]);
    assertThat(ended.status()).as(ended.said()).isZero();
    return program;
  }

  private static List<String> command(List<String> options, Path program, List<Path> sources) {
    List<String> words = new ArrayList<>(List.of(compiler()));
    words.addAll(OPTIONS);
    words.addAll(options);
    words.add("-o");
    words.add(program.toString());
    sources.forEach(source -> words.add(source.toString()));
    words.add("-lm");
    return words;
  }

  /** Runs a program with numbers on its standard input; returns those on its standard output. */
  static double[] run(Path program, List<String> arguments, double[] numbers) throws IOException {
    ByteBuffer given =
        ByteBuffer.allocate(numbers.length * Double.BYTES).order(ByteOrder.nativeOrder());
    given.asDoubleBuffer().put(numbers);
    List<String> words = new ArrayList<>(List.of(program.toString()));
    words.addAll(arguments);
    Ended ended = ended(program.resolveSibling("."), words, given.array());
    assertThat(ended.status()).as(ended.said()).isZero();
    byte[] output = Files.readAllBytes(ended.output());
    double[] result = new double[output.length / Double.BYTES];
    ByteBuffer.wrap(output).order(ByteOrder.nativeOrder()).asDoubleBuffer().get(result);
    return result;
  }

  /** Runs a program without input; returns the lines that it wrote. */
  static List<String> lines(Path program, List<String> arguments) throws IOException {
    List<String> words = new ArrayList<>(List.of(program.toString()));
    words.addAll(arguments);
    Ended ended = ended(program.resolveSibling("."), words, new byte[0]);
    assertThat(ended.status()).as(ended.said()).isZero();
    return Files.readAllLines(ended.output());
  }

  private record Ended(int status, Path output, String said) {}

  private static Ended ended(Path folder, List<String> words, byte[] input) throws IOException {
    Path given = Files.createTempFile(folder, "given", ".bin");
    Path output = Files.createTempFile(folder, "output", ".bin");
    Path said = Files.createTempFile(folder, "said", ".txt");
    Files.write(given, input);
    Process process =
        new ProcessBuilder(words)
            .redirectInput(given.toFile())
            .redirectOutput(output.toFile())
            .redirectError(said.toFile())
            .start();
    try {
      int status = process.waitFor();
      String text = new String(Files.readAllBytes(said), StandardCharsets.UTF_8);
      return new Ended(status, output, text);
    } catch (InterruptedException e) {
      process.destroyForcibly();
      Thread.currentThread().interrupt();
      throw new IOException("told to stop while " + words.get(0) + " ran", e);
    }
  }
}
