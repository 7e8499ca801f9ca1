package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The integrators' JAR in a program that knows nothing else of this project. */
class OdeLibraryIT {
  private static final Pattern BLOCK = Pattern.compile("```(\\w*)\n(.*?)```", Pattern.DOTALL);

  @TempDir Path directory;

  @Test
  void firstProgramOfThePageIsCompiledAndRunWithTheJarAlone() throws IOException {
    Path page = WorkingTree.TOP.resolve("docs/ode-library.md");
    List<MatchResult> blocks =
        BLOCK
            .matcher(String.join("\n", Documentation.section(page, "A program of ten lines")))
            .results()
            .toList();
    String program = textOf(blocks, "java");
    Files.writeString(directory.resolve("Ball.java"), program);
    Terminal terminal = new Terminal(directory);
    String jar = jar().toString();

    terminal.run("javac", "-Xlint:all", "-Werror", "-cp", jar, "-d", ".", "Ball.java").orFail();
    String classPath = jar + File.pathSeparator + directory;
    List<String> printed =
        terminal
            .run("java", "-Duser.language=en", "-cp", classPath, "Ball")
            .orFail()
            .stdout()
            .lines()
            .toList();

    assertThat(printed).isEqualTo(textOf(blocks, "").lines().toList());
  }

  /** Returns the first block in a language. */
  private static String textOf(List<MatchResult> blocks, String language) {
    return blocks.stream()
        .filter(block -> block.group(1).equals(language))
        .findFirst()
        .orElseThrow()
        .group(2);
  }

  private static Path jar() throws IOException {
    Path target = WorkingTree.TOP.resolve("solver-core/solver-ode/target");
    try (DirectoryStream<Path> jars = Files.newDirectoryStream(target, "solver-ode-*.jar")) {
      for (Path jar : jars) {
        if (!jar.toString().endsWith("-tests.jar")) {
          return jar;
        }
      }
    }
    throw new AssertionError("no JAR of the integrators in " + target);
  }
}
