package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A program in another language uses the service: examples/cpp-client, as its README says. */
class CppClientIT {
  /** The address the README's commands name. */
  private static final String DOCUMENTED_PORT = ":15000/";

  @TempDir static Path directory;
  private static Terminal terminal;
  private static int port;
  private static Terminal.Running server;
  private static String runCommand;
  private static Terminal.Ended run;

  @BeforeAll
  static void buildAndRunAsTheReadmeSays() throws IOException {
    terminal = new Terminal(directory);
    assumeTrue(
        List.of("omniidl", "g++", "make").stream()
            .allMatch(tool -> terminal.shell("command -v " + tool).exitStatus() == 0),
        "the C++ client is not tested: it needs omniidl, g++, make and libomniorb4-dev");
    WorkingTree.mirrorIn(directory);
    List<String> commands =
        Documentation.commandsOf(WorkingTree.TOP.resolve("examples/cpp-client/README.md"));
    assertThat(commands).hasSize(2);
    terminal.shell(commands.get(0)).orFail();
    port = Service.freePort();
    server = Service.startServer(directory, port);
    runCommand = commands.get(1).replace(DOCUMENTED_PORT, ":" + port + "/");
    run = terminal.shell(runCommand).orFail();
  }

  @AfterAll
  static void stopServer() throws IOException {
    WorkingTree.unmirror(directory);
    if (server != null) {
      server.close();
    }
  }

  @Test
  void pullsTheResultsTheJavaClientWrites() {
    terminal
        .mech(
            "simulate",
            WorkingTree.PENDULUM.toString(),
            "--server",
            Service.url(port),
            "--out",
            "java.csv")
        .orFail();

    ResultRows java = ResultRows.read(directory.resolve("java.csv"));
    // 17 digits read back to the same double: the tables are equal, not close.
    assertThat(ResultRows.read(directory.resolve("r.csv"))).isEqualTo(java);
  }

  @Test
  void isToldHowTheRunGoes() {
    assertThat(callbacks(run, "status")).isPositive();
    assertThat(run.stderr()).contains("status: running", "status: done");
  }

  @Test
  void isToldHowFarALongRunIs() {
    // A thousand seconds of motion take long enough for several of the ten a second.
    Terminal.Ended longRun =
        terminal.shell(runCommand.replace("r.csv", "long.csv t-end=1000 t-step=1")).orFail();

    assertThat(callbacks(longRun, "progress")).isPositive();
  }

  @Test
  void receivesTheRunReport() {
    assertThat(run.stdout()).contains("\"scene\"", "FiveBarPendulum", "rows: 301");
  }

  @Test
  void optionsReachTheServer() {
    terminal.shell(runCommand.replace("r.csv", "tight.csv rtol=1e-10 atol=1e-12")).orFail();

    assertThat(PendulumReference.errorOf(ResultRows.read(directory.resolve("tight.csv"))))
        .isLessThan(1e-8);
  }

  @Test
  void modelErrorReachesItWithFileAndLine() throws IOException {
    Files.writeString(directory.resolve("bad.xml"), "<MechML>\n<oops/>\n</MechML>\n");

    Terminal.Ended refused =
        terminal.shell(runCommand.replace("examples/pendulum/pendulum.xml", "bad.xml"));

    assertThat(refused.exitStatus()).isEqualTo(2);
    assertThat(refused.stderr()).containsPattern("bad\\.xml:\\d+:\\d+: M-\\d{3} ");
  }

  private static int callbacks(Terminal.Ended run, String kind) {
    Matcher count = Pattern.compile(kind + "=(\\d+)").matcher(run.stdout());
    assertThat(count.find()).as(run.toString()).isTrue();
    return Integer.parseInt(count.group(1));
  }
}
