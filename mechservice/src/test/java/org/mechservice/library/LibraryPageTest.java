package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The programs of docs/library.md and docs/first-steps.md print what stands there; the former are
 * those of examples/library.
 */
class LibraryPageTest {
  private static final Path PAGE = Path.of("../docs/library.md");
  private static final Path FIRST_STEPS = Path.of("../docs/first-steps.md");
  private static final Path NEW_MODEL =
      Path.of("../mechcli/src/main/resources/org/mechservice/cli/model/new-model.xml");
  private static final Path EXAMPLES = Path.of("../examples/library");
  private static final Pattern PROGRAM =
      Pattern.compile("```java\n(.*?)```\n\nIt prints\n\n```\n(.*?)```", Pattern.DOTALL);
  private static final Pattern NAME = Pattern.compile("final class (\\w+) ");

  @TempDir private Path folder = Path.of("");

  /** A program of the page and what it prints. */
  record Program(String name, String text, String printed) {
    @Override
    public String toString() {
      return name;
    }
  }

  static Stream<Program> allPrograms() throws IOException {
    return Stream.concat(programs(PAGE), programs(FIRST_STEPS));
  }

  private static Stream<Program> programs(Path page) throws IOException {
    return PROGRAM.matcher(Files.readString(page)).results().map(LibraryPageTest::program);
  }

  private static Program program(MatchResult found) {
    MatchResult name = NAME.matcher(found.group(1)).results().findFirst().orElseThrow();
    return new Program(name.group(1), found.group(1), found.group(2));
  }

  @ParameterizedTest
  @MethodSource("allPrograms")
  void programPrintsWhatStandsBehindIt(Program program) throws Exception {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    assumeTrue(compiler != null, "this Java has no compiler");
    Path model = folder.resolve("pendulum.xml");
    Files.writeString(model, Files.readString(NEW_MODEL).replace("@NAME@", "pendulum"));
    String text =
        program
            .text()
            .replace("Path.of(\"examples/", "Path.of(\"../examples/")
            .replace("\"pendulum.xml\"", "\"" + model.toString().replace('\\', '/') + "\"")
            .replace("printf(", "printf(java.util.Locale.ROOT, ")
            .replace("final class", "public final class");
    Path file = Files.writeString(folder.resolve(program.name() + ".java"), text);
    String classPath = System.getProperty("java.class.path", "");
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    int status =
        compiler.run(
            null,
            said,
            said,
            "-proc:none",
            "-cp",
            classPath,
            "-d",
            folder.toString(),
            file.toString());
    assertThat(status).as(said.toString(StandardCharsets.UTF_8)).isZero();
    assertThat(output(program.name()).replace(System.lineSeparator(), "\n"))
        .isEqualTo(program.printed());
  }

  private String output(String mainClass) throws Exception {
    PrintStream before = System.out;
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (URLClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()})) {
      System.setOut(new PrintStream(bytes, true, StandardCharsets.UTF_8));
      loader
          .loadClass(mainClass)
          .getMethod("main", String[].class)
          .invoke(null, (Object) new String[0]);
    } finally {
      System.setOut(before);
    }
    return bytes.toString(StandardCharsets.UTF_8);
  }

  @Test
  void examplesAreTheProgramsOfThePage() throws IOException {
    List<Program> programs = programs(PAGE).toList();
    for (Program program : programs) {
      assertThat(EXAMPLES.resolve(program.name() + ".java")).hasContent(program.text());
    }
    try (Stream<Path> files = Files.list(EXAMPLES)) {
      assertThat(files.filter(file -> file.toString().endsWith(".java"))).hasSize(programs.size());
    }
  }
}
