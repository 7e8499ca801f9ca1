package org.mechservice.solver.standalone;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.mechanism.FiveBarPendulum;
import org.mechservice.solver.ode.adams.De;
import org.mechservice.solver.simulation.Simulation;
import org.mechservice.solver.simulation.equations.ExplicitForm;

class StandaloneTest {
  @TempDir private Path folder;

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  @Test
  void writesResultsUnitsAndReport() throws IOException {
    Path csv = folder.resolve("l.csv");
    assertThat(run("--out", csv.toString())).isZero();
    assertThat(Files.readAllLines(csv)).hasSize(12).first().asString().startsWith("t,j1.q,j2.q");
    assertThat(folder.resolve("l.units.json")).exists();
    assertThat(text(out)).contains("scene", "FiveBarPendulum", "energy drift");
  }

  @Test
  void commandLineOverridesTheModelsSettings() {
    assertThat(run("--t-end", "0.2", "--t-step=0.1", "--rtol", "1e-8", "--json")).isZero();
    assertThat(text(out)).contains("\"rows\": 3", "\"relativeTolerance\": 1e-8");
  }

  @Test
  void quietPrintsNothing() {
    assertThat(run("--quiet", "--t-end", "0.1")).isZero();
    assertThat(text(out) + text(err)).isEmpty();
  }

  @Test
  void helpListsTheOptionsAndRunsNothing() {
    assertThat(run("--help")).isZero();
    assertThat(text(out)).contains("--t-end", "--columns", "Exit status");
  }

  @Test
  void driftOfTheEnergyBalanceEndsTheRunWhereAskedTo() {
    assertThat(run("--rtol", "1e-2", "--atol", "1e-2", "--max-drift=1e-12", "--quiet"))
        .isEqualTo(1);
    assertThat(text(err)).contains("N-016 t=", "at most 1.0E-12 is allowed");
  }

  @Test
  void strictAccuracyIsSaidInTheReportAndTakesMoreEvaluations() {
    assertThat(run("--json")).isZero();
    String standard = text(out);
    out.reset();
    assertThat(run("--json", "--accuracy", "strict")).isZero();
    String strict = text(out);
    assertThat(standard).doesNotContain("accuracy");
    assertThat(strict).contains("\"accuracy\": \"strict\"");
    assertThat(evaluations(strict)).isGreaterThan(evaluations(standard));
  }

  private static int evaluations(String report) {
    Matcher number = Pattern.compile("\"evaluations\": (\\d+)").matcher(report);
    assertThat(number.find()).isTrue();
    return Integer.parseInt(number.group(1));
  }

  @CsvSource({
    "--frobnicate, unknown option",
    "--rtol=abc, not \"abc\"",
    "--rtol=NaN, not \"NaN\"",
    "--max-drift=0, must be positive",
    "--out, lacks its value",
    "--accuracy=sharp, --accuracy is",
    "--columns=wheels, no column group",
    "--columns=reactions, --columns reactions",
    "--t-end=-5, end time",
    "--rtol=1e-20, 1.0E-20"
  })
  @ParameterizedTest
  void badUsageIsOneMessageAndStatusTwo(String option, String message) {
    assertThat(run(option)).isEqualTo(2);
    assertThat(text(err)).contains(message).doesNotContain("\tat ");
    assertThat(folder).isEmptyDirectory();
  }

  private int run(String... args) {
    DataDrivenModel model =
        new DataDrivenModel(
            FiveBarPendulum.mechanism(), new RunSettings(0, 1, 0.1, "DE", 1e-5, 1e-5));
    return new Standalone(
            () -> model,
            new Simulation(De::new, new ExplicitForm()),
            "joints,energy",
            "joints",
            print(out),
            print(err))
        .run(args);
  }

  private static PrintStream print(ByteArrayOutputStream bytes) {
    return new PrintStream(bytes, true, StandardCharsets.UTF_8);
  }

  private static String text(ByteArrayOutputStream bytes) {
    return bytes.toString(StandardCharsets.UTF_8);
  }
}
