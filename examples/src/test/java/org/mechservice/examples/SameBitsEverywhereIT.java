package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** One model gives one file, byte for byte, wherever it runs. */
class SameBitsEverywhereIT {
  private static final String MODEL = WorkingTree.PENDULUM.toString();
  private static final String HOST = "workshop";

  @TempDir static Path directory;
  private static Terminal terminal;
  private static int port;
  private static Terminal.Running server;
  private static Terminal.Running host;

  @BeforeAll
  static void startServerAndHost() {
    terminal = new Terminal(directory);
    port = Service.freePort();
    server = Service.startServer(directory, port);
    host = Service.startHost(directory, port, HOST);
    terminal.mech("simulate", MODEL, "--out", "embedded.csv").orFail();
  }

  @AfterAll
  static void stopServerAndHost() {
    host.close();
    server.close();
  }

  private static void assertSameAsEmbedded(String file) {
    assertThat(directory.resolve(file)).hasSameBinaryContentAs(directory.resolve("embedded.csv"));
  }

  @Test
  void downloadedModelRunsToTheSameBits() {
    terminal.mech("simulate", MODEL, "--mode", "local", "--out", "local.csv").orFail();

    assertSameAsEmbedded("local.csv");
  }

  @Test
  void serverGivesTheSameBits() {
    terminal.mech("simulate", MODEL, "--server", Service.url(port), "--out", "server.csv").orFail();

    assertSameAsEmbedded("server.csv");
  }

  @Test
  void registeredHostRunsToTheSameBits() {
    Report report =
        Report.printedBy(
            terminal.mech(
                "simulate",
                MODEL,
                "--server",
                Service.url(port),
                "--host",
                HOST,
                "--out",
                "host.csv",
                "--json"));

    assertThat(report.text("where")).contains(HOST);
    assertSameAsEmbedded("host.csv");
  }

  @Test
  void modelDownloadedFromAHostRunsToTheSameBits() {
    terminal
        .mech(
            "simulate",
            MODEL,
            "--mode",
            "local",
            "--server",
            Service.url(port),
            "--host",
            HOST,
            "--out",
            "host-local.csv")
        .orFail();

    assertSameAsEmbedded("host-local.csv");
  }

  @Test
  void standaloneJarRunsToTheSameBitsInAnEmptyDirectory(@TempDir Path empty) {
    terminal.mech("build", MODEL, "-o", "p.jar", "--standalone").orFail();

    new Terminal(empty)
        .run("java", "-jar", directory.resolve("p.jar").toString(), "--out", "l.csv")
        .orFail();

    assertThat(empty.resolve("l.csv")).hasSameBinaryContentAs(directory.resolve("embedded.csv"));
  }

  @Test
  void ode113GivesTheSameBitsRemoteAndLocal() {
    terminal.mech("simulate", MODEL, "--integrator", "ode113", "--out", "remote113.csv").orFail();
    terminal
        .mech(
            "simulate", MODEL, "--integrator", "ode113", "--mode", "local", "--out", "local113.csv")
        .orFail();

    assertThat(directory.resolve("local113.csv"))
        .hasSameBinaryContentAs(directory.resolve("remote113.csv"));
  }

  /** A spring and a damper so stiff that the run soon changes from ode113 to ode15s. */
  private static Terminal.Ended stiff(String command, String... further) {
    String file = WorkingTree.TOP.resolve("examples/extremes/stiff_1e9_c1e5.xml").toString();
    List<String> all = new ArrayList<>(List.of(command, file));
    all.addAll(List.of("--integrator", "switching", "--formulation", "DTR"));
    all.addAll(List.of(further));
    return terminal.mech(all.toArray(String[]::new)).orFail();
  }

  @Test
  void methodsThatChangeOnTheWayGiveTheSameBitsRemoteLocalAndStandalone() {
    assertThat(stiff("simulate", "--out", "stiff-remote.csv").stdout())
        .contains("N-015")
        .contains("The method changes from ode113 to ode15s");
    stiff("simulate", "--mode", "local", "--out", "stiff-local.csv");
    stiff("build", "-o", "stiff.jar", "--standalone");
    terminal.run("java", "-jar", "stiff.jar", "--out", "stiff-alone.csv").orFail();

    for (String place : List.of("stiff-local.csv", "stiff-alone.csv")) {
      assertThat(directory.resolve(place))
          .hasSameBinaryContentAs(directory.resolve("stiff-remote.csv"));
    }
  }

  /** Runs an extreme scene with the rows written to a file; returns how it ended. */
  private static Terminal.Ended extreme(String scene, String mode, String rows) {
    String file = WorkingTree.TOP.resolve("examples/extremes").resolve(scene).toString();
    return terminal.mech(
        "simulate", file, "--server", Service.url(port), "--mode", mode, "--quiet", "--out", rows);
  }

  /** Rows are compared byte by byte, messages letter by letter. */
  private static void assertSameRemoteAndLocal(String scene) throws IOException {
    Path remoteRows = directory.resolve(scene + "-remote.csv");
    Path localRows = directory.resolve(scene + "-local.csv");

    Terminal.Ended remote = extreme(scene, "remote", remoteRows.toString());
    Terminal.Ended local = extreme(scene, "local", localRows.toString());

    assertThat(local.exitStatus()).as(scene).isEqualTo(remote.exitStatus());
    assertThat(local.stderr().replace(localRows.toString(), "FILE"))
        .as(scene)
        .isEqualTo(remote.stderr().replace(remoteRows.toString(), "FILE"));
    assertThat(Files.exists(localRows)).as(scene).isEqualTo(Files.exists(remoteRows));
    if (Files.exists(remoteRows)) {
      assertThat(localRows).as(scene).hasSameBinaryContentAs(remoteRows);
    }
  }

  @ValueSource(strings = {"stiff_1e9_c1e5.xml", "massless_tip.xml", "start_off_1e-6.xml"})
  @ParameterizedTest
  void extremeSceneGivesTheSameBitsAndWordsRemoteAndLocal(String scene) throws IOException {
    assertSameRemoteAndLocal(scene);
  }

  @Test
  @Tag("soak")
  void wholeSuiteGivesTheSameBitsAndWordsRemoteAndLocal() throws IOException {
    List<String> cases =
        Files.readAllLines(WorkingTree.TOP.resolve("examples/extremes/cases.csv")).stream()
            .filter(line -> !line.startsWith("#"))
            .map(line -> line.substring(0, line.indexOf(',')))
            .toList();
    assertThat(cases).isNotEmpty();
    for (String scene : cases) {
      assertSameRemoteAndLocal(scene);
    }
  }

  @Test
  void administratorSeesServerHostAndRunningSimulation() {
    // An hour of pendulum: still running when the administrator looks.
    try (Terminal.Running simulation =
        terminal.startMech(
            "simulate", MODEL, "--server", Service.url(port), "--t-end", "100000", "--quiet")) {
      simulation.awaitThat(
          "FiveBarPendulum in the list of simulations",
          () -> Service.status(terminal, port).contains("FiveBarPendulum"));
    }
    assertThat(Service.status(terminal, port)).contains(HOST);
  }
}
