package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HashMap;
import java.util.Map;
import java.util.spi.ToolProvider;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.solver.standalone.Launcher;

/** {@code ./mech build --standalone}: a model that needs nothing but Java. */
class StandaloneJarIT {
  @TempDir static Path directory;
  private static Path jar;
  private static Terminal.Ended build;

  @BeforeAll
  static void buildJar() {
    jar = directory.resolve("p.jar");
    build =
        new Terminal(directory)
            .mech("build", WorkingTree.PENDULUM.toString(), "-o", "p.jar", "--standalone")
            .orFail();
  }

  private static Terminal.Ended javaJar(String... options) {
    String[] command = new String[options.length + 3];
    command[0] = "java";
    command[1] = "-jar";
    command[2] = jar.toString();
    System.arraycopy(options, 0, command, 3, options.length);
    return new Terminal(directory).run(command);
  }

  @Test
  void isSmallerThanTheWholeSolverByAThird() throws IOException {
    // The whole solver may have 125 KB, as the paper's had; a model takes what it needs.
    assertThat(Files.size(jar)).isLessThan(125 * 1024 * 2 / 3);
  }

  @Test
  void buildPrintsTheSizes() throws IOException {
    assertThat(build.stdout()).contains(Long.toString(Files.size(jar)));
  }

  @Test
  void modelsClassesAndRuntimeStayWithinTheirSizes() {
    Report report =
        Report.printedBy(
            new Terminal(directory)
                .mech("simulate", WorkingTree.PENDULUM.toString(), "--mode", "local", "--json"));

    assertThat(report.number("modelClassBytes")).isPositive().isLessThanOrEqualTo(4 * 1024);
    assertThat(report.number("runtimeJarBytes")).isPositive().isLessThanOrEqualTo(125 * 1024);
  }

  @Test
  void needsNothingButTheBaseOfJavaAndNoNetwork() throws IOException {
    String classes = withSolverUnpacked(jar).toString();
    StringWriter packages = new StringWriter();
    ToolProvider.findFirst("jdeps")
        .orElseThrow()
        .run(new PrintWriter(packages), new PrintWriter(packages), "-summary", classes);
    assertThat(packages.toString().strip()).isEqualTo("unpacked -> java.base");

    StringWriter details = new StringWriter();
    ToolProvider.findFirst("jdeps")
        .orElseThrow()
        .run(new PrintWriter(details), new PrintWriter(details), classes);
    assertThat(details.toString()).doesNotContain("java.net", "java.rmi");
  }

  /** Returns a folder with the JAR's class files, those in the file of the solver among them. */
  private static Path withSolverUnpacked(Path jar) throws IOException {
    Path folder = jar.resolveSibling("unpacked");
    try (ZipFile zip = new ZipFile(jar.toFile())) {
      for (ZipEntry entry : Collections.list(zip.entries())) {
        if (entry.getName().endsWith(".class")) {
          write(folder.resolve(entry.getName()), zip.getInputStream(entry).readAllBytes());
        }
      }
      ZipEntry solver = zip.getEntry(Launcher.SOLVER);
      Map<String, byte[]> classes = new HashMap<>();
      try (InputStream in = zip.getInputStream(solver)) {
        assertThat(Launcher.read(in, classes)).endsWith("Main");
      }
      for (Map.Entry<String, byte[]> file : classes.entrySet()) {
        write(folder.resolve(file.getKey().replace('.', '/') + ".class"), file.getValue());
      }
    }
    return folder;
  }

  private static void write(Path file, byte[] bytes) throws IOException {
    Files.createDirectories(file.resolveSibling("."));
    Files.write(file, bytes);
  }

  @Test
  void refusesColumnsItWasBuiltWithoutAndSaysHowToGetThem() {
    Terminal.Ended run = javaJar("--columns", "bodies");

    assertThat(run.exitStatus()).isEqualTo(2);
    assertThat(run.stderr())
        .contains("mech build", "--columns bodies")
        .doesNotContain("\tat ", "Exception");
  }

  @Test
  void refusesAnOptionItDoesNotHave() {
    Terminal.Ended run = javaJar("--integrator", "ode113");

    assertThat(run.exitStatus()).isEqualTo(2);
    assertThat(run.stderr()).contains("--integrator").doesNotContain("\tat ", "Exception");
  }

  @Test
  void explainsItsOptions() {
    assertThat(javaJar("--help").orFail().stdout()).contains("--t-end", "--rtol", "--out");
  }
}
