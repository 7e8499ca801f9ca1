package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code ./mech simulate} on the paper's pendulum. */
class SimulatePendulumIT {
  private static final String MODEL = WorkingTree.PENDULUM.toString();

  @TempDir Path directory;
  private Terminal terminal;

  @BeforeEach
  void openTerminal() {
    terminal = new Terminal(directory);
  }

  private ResultRows results(String... options) {
    String[] command = new String[options.length + 4];
    command[0] = "simulate";
    command[1] = MODEL;
    command[2] = "--out";
    command[3] = "r.csv";
    System.arraycopy(options, 0, command, 4, options.length);
    terminal.mech(command).orFail();
    return ResultRows.read(directory.resolve("r.csv"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"DE", "ode113"})
  void tightTolerancesReproduceTheReference(String integrator) {
    ResultRows results = results("--integrator", integrator, "--rtol", "1e-10", "--atol", "1e-12");

    // The project's own bound: a hundred times the tolerance, for what the motion amplifies in 3 s.
    assertThat(PendulumReference.errorOf(results)).isLessThan(1e-8);
  }

  @ParameterizedTest
  @ValueSource(strings = {"DE", "ode113"})
  void theFilesTolerancesGiveThreeDigits(String integrator) {
    // 1e-5 in the file, amplified up to a hundredfold in 3 s.
    assertThat(PendulumReference.errorOf(results("--integrator", integrator))).isLessThan(1e-3);
  }

  @Test
  void csvHasTimeThenPositionsThenVelocitiesAtEveryOutputTime() throws IOException {
    ResultRows results = results();

    assertThat(results.columns())
        .containsExactly(
            "t", "j1.q", "j2.q", "j3.q", "j4.q", "j5.q", "j1.v", "j2.v", "j3.v", "j4.v", "j5.v");
    assertThat(results.column("t")).hasSize(301).startsWith(0, 0.01).endsWith(3.0);
    assertThat(Files.readString(directory.resolve("r.csv"))).endsWith("\r\n");
  }

  @Test
  void aSecondFileNamesTheUnitOfEveryColumn() throws IOException {
    List<String> columns = results().columns();

    assertThat(Files.readString(directory.resolve("r.units.json")))
        .contains(columns)
        .contains("\"rad\"", "\"rad/s\"", "\"s\"");
  }

  @Test
  void reportStatesHowWellEnergyWasKept() {
    Report report =
        Report.printedBy(
            terminal.mech("simulate", MODEL, "--json", "--rtol", "1e-10", "--atol", "1e-12"));

    // Relative to the energy exchanged, a hundred times the tolerance as for the states.
    assertThat(report.number("energyDrift") / report.number("energyScale")).isLessThan(1e-8);
  }

  @Test
  void reportNamesMethodCostAndSetUpTimes() {
    Report report = Report.printedBy(terminal.mech("simulate", MODEL, "--json"));

    assertThat(report.text("scene")).isEqualTo("FiveBarPendulum");
    assertThat(report.text("formulation")).isEqualTo("DTR");
    assertThat(report.text("integrator")).isEqualTo("DE");
    assertThat(report.number("rows")).isEqualTo(301);
    assertThat(report.number("steps")).isPositive();
    assertThat(report.number("evaluations")).isGreaterThan(report.number("steps"));
    assertThat(List.of("t1c", "t1s", "tcc", "tR", "where", "modelSha256", "solverVersion"))
        .allMatch(report::has);
  }

  @Test
  void reportForPeopleIsPrintedByDefault() {
    assertThat(terminal.mech("simulate", MODEL).orFail().stdout())
        .contains("FiveBarPendulum", "DTR", "DE")
        .containsIgnoringCase("energy drift");
  }

  @Test
  void commandLineOverridesTheFile() {
    ResultRows results = results("--t-end", "0.5", "--t-step", "0.25");

    assertThat(results.column("t")).containsExactly(0, 0.25, 0.5);
  }
}
