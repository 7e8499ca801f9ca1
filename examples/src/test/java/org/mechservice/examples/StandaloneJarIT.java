package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.spi.ToolProvider;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

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

  /** A pendulum leaves most of the solver out. */
  @Test
  void isAFractionOfTheWholeSolver() throws IOException {
    assertThat(Files.size(jar)).isLessThan(runtimeJarBytes() / 3);
  }

  private static long runtimeJarBytes() {
    Report report =
        Report.printedBy(
            new Terminal(directory)
                .mech("simulate", WorkingTree.PENDULUM.toString(), "--mode", "local", "--json"));
    return (long) report.number("runtimeJarBytes");
  }

  @Test
  void buildPrintsTheSizes() throws IOException {
    assertThat(build.stdout()).contains(Long.toString(Files.size(jar)));
  }

  @Test
  void modelsClassesStayWithinTheirSizeAndTheRuntimesIsReported() {
    Report report =
        Report.printedBy(
            new Terminal(directory)
                .mech("simulate", WorkingTree.PENDULUM.toString(), "--mode", "local", "--json"));

    assertThat(report.number("modelClassBytes")).isPositive().isLessThanOrEqualTo(4 * 1024);
    assertThat(report.number("runtimeJarBytes")).isPositive();
  }

  @Test
  void needsNothingButTheBaseOfJavaAndNoNetwork() throws IOException {
    StringWriter packages = new StringWriter();
    ToolProvider.findFirst("jdeps")
        .orElseThrow()
        .run(new PrintWriter(packages), new PrintWriter(packages), "-summary", jar.toString());
    assertThat(packages.toString().strip()).isEqualTo("p.jar -> java.base");

    StringWriter details = new StringWriter();
    ToolProvider.findFirst("jdeps")
        .orElseThrow()
        .run(new PrintWriter(details), new PrintWriter(details), jar.toString());
    assertThat(details.toString()).doesNotContain("java.net", "java.rmi");
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
