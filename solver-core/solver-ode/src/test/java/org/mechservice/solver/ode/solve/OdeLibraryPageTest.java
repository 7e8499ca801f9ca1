package org.mechservice.solver.ode.solve;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.hipparchus.analysis.solvers.BracketingNthOrderBrentSolver;
import org.hipparchus.ode.ODEIntegrator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The programs of docs/ode-library.md, ours and those for Hipparchus, print what stands there. */
class OdeLibraryPageTest {
  private static final Path PAGE = Path.of("..", "..", "docs", "ode-library.md");
  private static final Pattern BLOCK = Pattern.compile("```(\\w*)\n(.*?)```", Pattern.DOTALL);
  private static final String HIPPARCHUS =
      "import org.hipparchus.ode.*; import org.hipparchus.ode.nonstiff.*;"
          + " import org.hipparchus.ode.events.*; import org.hipparchus.ode.sampling.*;"
          + " import org.hipparchus.analysis.solvers.*;";
  private static final String OWN = "import org.mechservice.solver.ode.solve.*;";

  @TempDir Path folder;

  /**
   * A block of the page.
   *
   * @param title of its section
   * @param language empty for what a program prints
   */
  record Block(String title, String language, String text) {
    boolean isProgram() {
      return text.startsWith("// ");
    }

    @Override
    public String toString() {
      return title + ", " + text.lines().findFirst().orElse("");
    }
  }

  private static String page() throws IOException {
    return Files.readString(PAGE);
  }

  private static List<Block> blocks() throws IOException {
    List<Block> blocks = new ArrayList<>();
    for (String section : page().split("\n##+ ", -1)) {
      String title = section.lines().findFirst().orElse("");
      for (MatchResult block : BLOCK.matcher(section).results().toList()) {
        blocks.add(new Block(title, block.group(1), block.group(2)));
      }
    }
    return blocks;
  }

  static Stream<Block> programs() throws IOException {
    return blocks().stream().filter(Block::isProgram);
  }

  /** Returns what the programs of a section print. */
  private static String printed(String title) throws IOException {
    List<Block> block =
        blocks().stream().filter(b -> b.title().equals(title) && b.language().isEmpty()).toList();
    assertThat(block).as(title).hasSize(1);
    return block.get(0).text();
  }

  @ParameterizedTest
  @MethodSource("programs")
  void programPrintsWhatStandsBehindIt(Block program) throws Exception {
    String source =
        (program.text().startsWith("// Hipparchus") ? HIPPARCHUS : OWN)
            + "public class Program { public static void run(java.io.PrintStream out)"
            + " throws Exception {\n"
            + program
                .text()
                .replace("System.out.printf(", "out.printf(java.util.Locale.ROOT, ")
                .replace("System.out.println(", "out.println(")
                .replace("String.format(", "String.format(java.util.Locale.ROOT, ")
            + "}}";
    Path file = Files.writeString(folder.resolve("Program.java"), source);
    assertThat(run("-proc:none", "-cp", classPath(), "-d", folder.toString(), file.toString()))
        .isEmpty();

    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (URLClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()})) {
      PrintStream out = new PrintStream(bytes, true, StandardCharsets.UTF_8);
      loader.loadClass("Program").getMethod("run", PrintStream.class).invoke(null, out);
    }
    assertThat(bytes.toString(StandardCharsets.UTF_8).replace(System.lineSeparator(), "\n"))
        .isEqualTo(printed(program.title()));
  }

  /** Compiles; returns what the compiler says. */
  private static String run(String... arguments) {
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    ToolProvider.getSystemJavaCompiler().run(null, said, said, arguments);
    return said.toString(StandardCharsets.UTF_8);
  }

  private static String classPath() throws Exception {
    List<String> places = new ArrayList<>();
    for (Class<?> type :
        List.of(Ode.class, ODEIntegrator.class, BracketingNthOrderBrentSolver.class)) {
      places.add(place(type));
    }
    return String.join(File.pathSeparator, places);
  }

  private static String place(Class<?> type) throws Exception {
    return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
  }

  @Test
  void eachOfTheTenProblemsIsSolvedThreeTimes() throws IOException {
    List<String> titles =
        blocks().stream()
            .map(Block::title)
            .filter(title -> title.matches("\\d+\\. .*"))
            .distinct()
            .toList();
    assertThat(titles).hasSize(10);
    for (String title : titles) {
      List<String> kinds =
          blocks().stream()
              .filter(block -> block.title().equals(title))
              .map(block -> block.isProgram() ? block.toString() : block.language())
              .toList();
      assertThat(kinds)
          .containsExactly("python", title + ", // Hipparchus", title + ", // solver-ode", "");
    }
  }

  /** A program of a stranger's, with nothing but this library on its class path. */
  @Test
  void firstProgramOfThePageRuns() throws Exception {
    Block program =
        blocks().stream()
            .filter(b -> b.language().equals("java") && !b.isProgram())
            .findFirst()
            .orElseThrow();
    Path file = Files.writeString(folder.resolve("Ball.java"), program.text());
    Path java = Path.of(System.getProperty("java.home"), "bin", "java");
    Process process =
        new ProcessBuilder(
                java.toString(), "-Duser.language=en", "-cp", place(Ode.class), file.toString())
            .redirectErrorStream(true)
            .start();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(said).isZero();
    assertThat(said.replace(System.lineSeparator(), "\n")).isEqualTo(printed(program.title()));
    assertThat(program.text().lines().filter(line -> !line.isBlank())).hasSizeLessThanOrEqualTo(10);
  }

  @Test
  void coordinatesOfThePageAreThoseOfTheProjectWhichNeedsNothing() throws IOException {
    String pom = Files.readString(Path.of("pom.xml"));
    String wanted =
        page()
            .lines()
            .map(String::strip)
            .dropWhile(line -> !line.equals("<dependency>"))
            .takeWhile(line -> !line.equals("</dependency>"))
            .skip(1)
            .collect(Collectors.joining());
    assertThat(wanted)
        .isEqualTo(
            "<groupId>org.mechservice</groupId><artifactId>solver-ode</artifactId><version>"
                + Objects.requireNonNull(System.getProperty("project.version"))
                + "</version>");
    assertThat(pom).contains("<artifactId>solver-ode</artifactId>");
    for (String file : List.of("pom.xml", "../pom.xml", "../../pom.xml")) {
      String own =
          Files.readString(Path.of(file))
              .replaceAll("(?s)<dependencyManagement>.*</dependencyManagement>", "")
              .replaceAll("(?s)<build>.*</build>", "");
      assertThat(Arrays.stream(own.split("<dependency>", -1)).skip(1))
          .as(file)
          .allSatisfy(dependency -> assertThat(dependency).contains("<scope>test</scope>"));
    }
  }
}
