package org.mechservice.cli.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;

class FmuOptionTest {
  private static final String PENDULUM = "../examples/pendulum/pendulum.xml";
  private static final String SUSPENSION =
      "../examples/five-point-suspension/five-point-suspension.xml";

  @TempDir private Path folder = Path.of("");

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int build(String model, String target, String... more) {
    List<String> words =
        new ArrayList<>(List.of("build", model, "-o", folder.resolve(target).toString()));
    words.addAll(List.of(more));
    return Mech.run(new PrintWriter(out), new PrintWriter(err), words.toArray(new String[0]));
  }

  @ParameterizedTest
  @CsvSource({"2, sources/mech_fmi2.c", "3, sources/mech_fmi3.c"})
  void modelIsWrittenForTheVersionAskedFor(String version, String source) throws IOException {
    assertThat(build(PENDULUM, "p.fmu", "--fmi", version, "--platforms", "source"))
        .as(err.toString())
        .isEqualTo(ExitStatus.DONE);
    assertThat(out.toString()).contains("sources only");
    try (ZipFile file = new ZipFile(folder.resolve("p.fmu").toFile())) {
      assertThat(file.getEntry("modelDescription.xml")).isNotNull();
      assertThat(file.getEntry(source)).isNotNull();
      assertThat(file.getEntry("sources/example.c")).isNull();
    }
  }

  @Test
  void sameModelGivesSameBytes() throws IOException {
    build(PENDULUM, "a.fmu", "--platforms", "source");
    build(PENDULUM, "b.fmu", "--platforms", "source");
    assertThat(folder.resolve("a.fmu"))
        .hasBinaryContent(Files.readAllBytes(folder.resolve("b.fmu")));
  }

  @ParameterizedTest
  @CsvSource({
    "--fmi, 4, FMI 4",
    "--platforms, amiga, no platform \"amiga\"",
    "--coordinates, dependent, 'write projection, independent, or'",
    "--coordinates, independent:, 'write projection, independent, or'",
    "--formulation, XYZ, XYZ",
    "--simulation, 9, 9",
    "--code, shared, --code is for a JAR",
    "--source, x, --source is for a JAR",
    "--host, h, --host is for a JAR"
  })
  void whatCannotBeIsRefusedByNameBeforeAnythingIsWritten(
      String option, String value, String named) {
    assertThat(build(PENDULUM, "p.fmu", option, value)).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains(named);
    assertThat(folder).isEmptyDirectory();
  }

  @ParameterizedTest
  @CsvSource({"--standalone", "--compact"})
  void optionsOfJarsAreRefused(String option) {
    assertThat(build(PENDULUM, "p.fmu", option)).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-041").contains(option + " is for a JAR");
    assertThat(folder).isEmptyDirectory();
  }

  @ParameterizedTest
  @CsvSource({
    "--fmi, 2",
    "--platforms, source",
    "--coordinates, independent",
    "--class-as-input, fBody"
  })
  void optionsOfUnitsAreRefusedForJars(String option, String value) {
    assertThat(build(PENDULUM, "p.jar", option, value)).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-041").contains(option + " is for an FMU");
    assertThat(folder).isEmptyDirectory();
  }

  private int buildModule(String model, String... more) {
    List<String> words =
        new ArrayList<>(List.of("build", model, "--wasm", folder.resolve("m.wasm").toString()));
    words.addAll(List.of(more));
    return Mech.run(new PrintWriter(out), new PrintWriter(err), words.toArray(new String[0]));
  }

  @Test
  void modelBecomesAWebAssemblyModule() throws IOException {
    int status = buildModule(PENDULUM);
    assumeTrue(
        !err.toString().contains("no compiler for WebAssembly"),
        "no compiler for WebAssembly here");
    assertThat(status).as(err.toString()).isEqualTo(ExitStatus.DONE);
    assertThat(Files.readAllBytes(folder.resolve("m.wasm"))).startsWith(0, 'a', 's', 'm');
  }

  @ParameterizedTest
  @CsvSource({"--standalone, ", "--compact, ", "--code, shared", "--source, x", "-o, x.jar"})
  void optionsOfJarsAreRefusedForModules(String option, String value) {
    String[] words = value == null ? new String[] {option} : new String[] {option, value};
    assertThat(buildModule(PENDULUM, words)).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-041").contains(option + " is for a JAR");
    assertThat(buildModule(SUSPENSION)).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("S-170");
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void modelWithoutCodeInCIsRefusedByName() {
    assertThat(build(SUSPENSION, "s.fmu")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-170");
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void forcesWrittenAsClassesBecomeInputsIfAskedFor() throws IOException {
    String[] both = {"--class-as-input", "fBody", "--class-as-input", "fFpsSpringDamper"};
    assertThat(build(SUSPENSION, "s.fmu", "--class-as-input", "fBody"))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("S-170").contains("fFpsSpringDamper");
    assertThat(build(SUSPENSION, "s.fmu", "--class-as-input", "fWheel"))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("--class-as-input fWheel");
    assertThat(folder).isEmptyDirectory();
    List<String> words = new ArrayList<>(List.of(both));
    words.addAll(List.of("--platforms", "source"));
    assertThat(build(SUSPENSION, "s.fmu", words.toArray(new String[0])))
        .as(err.toString())
        .isEqualTo(ExitStatus.DONE);
    try (ZipFile file = new ZipFile(folder.resolve("s.fmu").toFile())) {
      String description =
          new String(
              file.getInputStream(file.getEntry("modelDescription.xml")).readAllBytes(),
              StandardCharsets.UTF_8);
      assertThat(description).contains("\"fBody+fFpsSpringDamper.Wheel.fz\"");
    }
  }
}
