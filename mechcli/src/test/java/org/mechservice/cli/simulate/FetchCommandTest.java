package org.mechservice.cli.simulate;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.RunState;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.service.limits.HostLimits;

/** Runs whose client is gone, fetched by their ids. */
@Tag("slow")
class FetchCommandTest {
  private static final Path MODEL = Path.of("../examples/pendulum/pendulum.xml");

  private final MechServerProcess server =
      MechServerProcess.start(
          new ServerSettings(
              "127.0.0.1",
              0,
              new HostOptions("lab", 2, HostLimits.DEFAULT.with("lease", 5), Optional.empty())));
  @TempDir private Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  @AfterEach
  void stop() {
    server.close();
  }

  private int mech(String... words) {
    out.getBuffer().setLength(0);
    err.getBuffer().setLength(0);
    return Mech.run(new PrintWriter(out), new PrintWriter(err), words);
  }

  private int fetch(String id, Path file) {
    return mech("fetch", id, "--server", server.url(), "--out", file.toString());
  }

  /** Starts a run and is gone without a word, as a client that was killed. */
  private String leftBehind(SimulationOptions options, RunState reached) throws IOException {
    try (MechConnection connection = MechConnection.open(server.url())) {
      MechSession session = connection.openSession();
      session.loadModel(MODEL);
      RemoteRun run = session.prepareRemoteRun(options);
      run.start();
      while (run.progress().state().compareTo(reached) < 0) {
        var unused = run.nextRow(Duration.ofMillis(50));
      }
      return run.id();
    }
  }

  private void awaitEndOfSessions() throws Exception {
    Eventually.holds(
        () ->
            mech("admin", "--server", server.url(), "servers", "--json") == 0
                && out.toString().contains("\"sessions\": 0"));
  }

  private Path simulated() {
    Path file = folder.resolve("simulated.csv");
    assertThat(mech("simulate", MODEL.toString(), "--quiet", "--out", file.toString())).isZero();
    return file;
  }

  @Test
  void completedRunIsFetchedWholeAsOftenAsOneLikes() throws Exception {
    String id = leftBehind(SimulationOptions.asInFile(), RunState.DONE);
    Path expected = simulated();
    for (String name : new String[] {"first.csv", "second.csv"}) {
      Path file = folder.resolve(name);
      assertThat(fetch(id, file)).as(err.toString()).isZero();
      assertThat(file).hasSameBinaryContentAs(expected);
      assertThat(out.toString()).contains("outcome", "completed");
    }
  }

  @Test
  void completedRunIsFetchedAfterItsSessionHasEndedUntilItsRetentionIsOver() throws Exception {
    String id = leftBehind(SimulationOptions.asInFile(), RunState.DONE);
    awaitEndOfSessions();
    assertThat(fetch(id, folder.resolve("r.csv"))).as(err.toString()).isZero();
    assertThat(mech("admin", "--server", server.url(), "limits", "retention=0")).isZero();
    String other = leftBehind(SimulationOptions.asInFile(), RunState.DONE);
    awaitEndOfSessions();
    assertThat(fetch(other, folder.resolve("late.csv"))).isEqualTo(ExitStatus.SERVER);
    assertThat(err.toString()).startsWith("S-011 there is no simulation " + other);
    assertThat(folder.resolve("late.csv")).doesNotExist();
  }

  @Test
  void runThatGoesOnIsHeldAndFetchedToItsEnd() throws Exception {
    SimulationOptions longer = SimulationOptions.asInFile().endTime(3000).outputStep(100);
    String id = leftBehind(longer, RunState.RUNNING);
    Path file = folder.resolve("r.csv");
    assertThat(fetch(id, file)).as(err.toString()).isZero();
    assertThat(Files.readAllLines(file)).hasSize(32);
  }

  @Test
  void runThatWasCutOffWithItsClientIsFetchedAsFarAsItCameAndIsNotSaidToBeStoppedOnRequest()
      throws Exception {
    SimulationOptions endless = SimulationOptions.asInFile().endTime(1e7).outputStep(100);
    String id = leftBehind(endless, RunState.RUNNING);
    awaitEndOfSessions();
    Path file = folder.resolve("r.csv");
    assertThat(fetch(id, file)).isEqualTo(ExitStatus.INTERRUPTED);
    assertThat(err.toString()).startsWith("S-045 the run was stopped at t=").hasLineCount(1);
    assertThat(file).isNotEmptyFile();
  }

  @Test
  void runThatHasToWaitSaysItsPlaceInTheQueue() throws Exception {
    SimulationOptions endless = SimulationOptions.asInFile().endTime(1e7).outputStep(1e4);
    try (MechConnection connection = MechConnection.open(server.url());
        MechSession session = connection.openSession()) {
      session.loadModel(MODEL);
      RemoteRun first = session.prepareRemoteRun(endless);
      RemoteRun second = session.prepareRemoteRun(endless);
      first.start();
      second.start();
      Thread waiting =
          new Thread(() -> mech("simulate", MODEL.toString(), "--server", server.url()));
      waiting.start();
      Eventually.holds(() -> err.toString().contains("waiting for room, place 1 in the queue"));
      first.cancel();
      waiting.join();
      assertThat(out.toString()).contains("completed");
      second.cancel();
    }
  }

  @Test
  void runIdIsToldWhereItIsNeeded() {
    assertThat(mech("simulate", MODEL.toString(), "--server", server.url())).isZero();
    assertThat(err.toString()).containsPattern("(?m)^simulation [0-9a-f-]{36}$");
  }

  @Test
  void whatCannotBeFetchedIsSaid() {
    assertThat(fetch("nosuch", folder.resolve("r.csv"))).isEqualTo(ExitStatus.SERVER);
    assertThat(err.toString()).startsWith("S-011 there is no simulation nosuch").hasLineCount(1);
    assertThat(mech("fetch", "x")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-041 fetch: name the server");
  }
}
