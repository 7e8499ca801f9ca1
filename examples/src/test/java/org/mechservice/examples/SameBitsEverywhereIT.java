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
        .contains("ode15s takes over from ode113");
    stiff("simulate", "--mode", "local", "--out", "stiff-local.csv");
    stiff("build", "-o", "stiff.jar", "--standalone");
    terminal.run("java", "-jar", "stiff.jar", "--out", "stiff-alone.csv").orFail();

    for (String place : List.of("stiff-local.csv", "stiff-alone.csv")) {
      assertThat(directory.resolve(place))
          .hasSameBinaryContentAs(directory.resolve("stiff-remote.csv"));
    }
  }

  /** Lines of the figures of the extreme scenes run on the server and here. */
  private static List<String> extremesRemoteAndLocal(String... further) throws IOException {
    List<String> all = new ArrayList<>(List.of("stability", "--quick", "--measure", "service"));
    all.addAll(List.of("--server", Service.url(port), "-o", "same"));
    all.addAll(List.of(further));
    terminal.mech(all.toArray(String[]::new)).orFail();
    List<String> lines = Files.readAllLines(directory.resolve("same/stability-service.csv"));
    return lines.subList(2, lines.size());
  }

  @Test
  void extremeScenesGiveTheSameBitsAndWordsRemoteAndLocal() throws IOException {
    assertThat(
            extremesRemoteAndLocal(
                "--case", "stiff_1e9_c1e5", "--case", "massless_tip", "--case", "start_off_1e-6"))
        .hasSize(3)
        .allSatisfy(line -> assertThat(line).contains(",yes,yes,"));
  }

  @Test
  @Tag("soak")
  void wholeSuiteGivesTheSameBitsAndWordsRemoteAndLocal() throws IOException {
    assertThat(extremesRemoteAndLocal())
        .isNotEmpty()
        .allSatisfy(line -> assertThat(line).contains(",yes,yes,"));
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
