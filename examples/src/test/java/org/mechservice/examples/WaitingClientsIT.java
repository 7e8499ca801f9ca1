package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Commands whose host dies, freezes or comes back, as users start all of them. */
class WaitingClientsIT {
  @TempDir private Path folder;

  private static Optional<ProcessHandle> hostNamed(String name, int serverPort) {
    return ProcessHandle.allProcesses()
        .filter(
            process -> {
              String line = process.info().commandLine().orElse("");
              return line.contains("mechcli.jar simhost --server " + Service.url(serverPort))
                  && line.endsWith("--name " + name);
            })
        .findFirst();
  }

  private static void signal(String what, ProcessHandle process) throws Exception {
    new ProcessBuilder("kill", what, Long.toString(process.pid())).start().waitFor();
  }

  @Test
  void hostThatDiesDuringTheSetUpIsReplaced() throws Exception {
    Files.writeString(folder.resolve("loops.xml"), HostileTenantIT.loops(200));
    int port = Service.freePort();
    Terminal terminal = new Terminal(folder);
    try (Terminal.Running server = Service.startServer(folder, port, "--capacity", "0");
        Terminal.Running a = Service.startHost(folder, port, "a");
        Terminal.Running run =
            terminal.startMech(
                "simulate",
                "loops.xml",
                "--server",
                Service.url(port),
                "--t-end",
                "1e-3",
                "--t-step",
                "1e-3",
                "--rtol",
                "1e-3")) {
      assertThat(server.stdout() + a.stdout()).isNotEmpty();
      run.awaitThat(
          "a session",
          () ->
              terminal
                  .mech("admin", "--server", Service.url(port), "sessions")
                  .stdout()
                  .contains(" a "));
      try (Terminal.Running b = Service.startHost(folder, port, "b")) {
        assertThat(b.stdout()).isNotEmpty();
        signal("-KILL", hostNamed("a", port).orElseThrow());
        Terminal.Ended ended = run.awaitEnd();
        assertThat(ended.exitStatus()).as(ended.toString()).isZero();
        assertThat(ended.stderr()).contains("the model is set up again");
      }
    }
  }

  @Test
  void frozenHostIsToldWithinSecondsAndTheRunGoesOnWithIt() throws Exception {
    int port = Service.freePort();
    Terminal terminal = new Terminal(folder);
    String pendulum = WorkingTree.PENDULUM.toString();
    terminal.mech("simulate", pendulum, "--t-end", "3000", "--out", "right.csv").orFail();
    try (Terminal.Running server = Service.startServer(folder, port, "--capacity", "0");
        Terminal.Running host = Service.startHost(folder, port, "a");
        Terminal.Running run =
            terminal.startMech(
                "simulate",
                pendulum,
                "--server",
                Service.url(port),
                "--t-end",
                "3000",
                "--out",
                "r.csv")) {
      assertThat(server.stdout() + host.stdout()).isNotEmpty();
      run.awaitThat("its identity", () -> run.stderr().contains("simulation "));
      ProcessHandle frozen = hostNamed("a", port).orElseThrow();
      signal("-STOP", frozen);
      try {
        run.awaitThat("the word that the host is silent", () -> run.stderr().contains("S-233"));
      } finally {
        signal("-CONT", frozen);
      }
      run.awaitEnd().orFail();
    }
    try (Stream<String> rows = Files.lines(folder.resolve("r.csv"))) {
      assertThat(rows).containsExactlyElementsOf(Files.readAllLines(folder.resolve("right.csv")));
    }
  }

  @Test
  void commandWaitsForAHostThatIsComingBack() throws Exception {
    int port = Service.freePort();
    Terminal terminal = new Terminal(folder);
    try (Terminal.Running server = Service.startServer(folder, port, "--capacity", "0");
        Terminal.Running run =
            terminal.startMech(
                "simulate", WorkingTree.PENDULUM.toString(), "--server", Service.url(port));
        Terminal.Running host = Service.startHost(folder, port, "a")) {
      assertThat(server.stdout() + host.stdout()).isNotEmpty();
      run.awaitEnd().orFail();
    }
  }

  @Test
  void interruptedRunLeavesItsCheckpoint() throws Exception {
    Terminal terminal = new Terminal(folder);
    for (String mode : new String[] {"remote", "local"}) {
      Path checkpoint = folder.resolve(mode + ".checkpoint");
      try (Terminal.Running run =
          terminal.startMech(
              "simulate",
              WorkingTree.PENDULUM.toString(),
              "--mode",
              mode,
              "--t-end",
              "1e8",
              "--t-step",
              "100",
              "--out",
              mode + ".csv",
              "--checkpoint",
              checkpoint.toString(),
              "--every",
              "1000")) {
        run.awaitThat("rows", () -> hasRows(folder.resolve(mode + ".csv")));
        run.terminate();
        Terminal.Ended ended = run.awaitEnd();
        assertThat(ended.exitStatus()).as(ended.toString()).isNotZero();
        assertThat(ended.stderr()).contains("Rows up to there are in");
        assertThat(checkpoint).isNotEmptyFile();
      }
    }
  }

  /** Returns whether rows are on disk, in the file that gets its name at the end. */
  private static boolean hasRows(Path file) {
    String name = file.getFileName().toString();
    try (Stream<Path> files = Files.list(file.getParent())) {
      return files
          .filter(other -> other.getFileName().toString().contains(name))
          .anyMatch(other -> other.toFile().length() > 0);
    } catch (java.io.IOException e) {
      return false;
    }
  }

  /** A machine without time for a command: it is held for longer than its server may be silent. */
  @Test
  void localRunDoesNotEndBecauseTheMachineIsBusy() throws Exception {
    Terminal terminal = new Terminal(folder);
    try (Terminal.Running run =
        terminal.startMech("simulate", WorkingTree.PENDULUM.toString(), "--out", "r.csv")) {
      for (int i = 0; i < 3; i++) {
        Thread.sleep(400);
        Optional<ProcessHandle> held = simulating();
        if (held.isPresent()) {
          signal("-STOP", held.get());
          Thread.sleep(6000);
          signal("-CONT", held.get());
        }
      }
      run.awaitEnd().orFail();
    }
  }

  private Optional<ProcessHandle> simulating() {
    return ProcessHandle.current()
        .descendants()
        .filter(process -> process.info().commandLine().orElse("").contains("mechcli.jar simulate"))
        .findFirst();
  }
}
