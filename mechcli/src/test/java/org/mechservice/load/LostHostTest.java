package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.Mech;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.client.run.RunListener;
import org.mechservice.client.run.RunResult;
import org.mechservice.guard.UserCode;
import org.mechservice.guard.UserCodePolicy;
import org.mechservice.idl.MechAdmin;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.omg.CORBA.IntHolder;

/** What becomes of a plain run whose host is killed. */
@Tag("slow")
class LostHostTest {
  /** Has many more rows than are on their way at once. */
  private static final SimulationOptions LONG =
      SimulationOptions.asInFile().endTime(500).outputStep(0.01);

  /** Goes on for as long as a test needs. */
  private static final SimulationOptions ENDLESS =
      SimulationOptions.asInFile().endTime(1e7).outputStep(5);

  /** The five-point suspension, with forces given as Java classes. */
  private static final Path USER_FORCES =
      Path.of("../examples/five-point-suspension/five-point-suspension.xml");

  /** Takes all rows; acts once, at a row far from the start. */
  private static final class Taker implements ResultSink {
    private final Action action;
    private long rows;
    private long bits;

    interface Action {
      void act() throws InterruptedException;
    }

    Taker(Action action) {
      this.action = action;
    }

    @Override
    public void begin(List<Variable> columns) {}

    @Override
    public void row(double[] values) {
      for (double value : values) {
        bits = 31 * bits + Double.doubleToRawLongBits(value);
      }
      rows++;
      if (rows == 1000) {
        try {
          action.act();
        } catch (InterruptedException e) {
          Thread.currentThread().interrupt();
        }
      }
    }
  }

  @Test
  void runWhoseHostIsKilledIsComputedElsewhereToTheSameBits() throws Exception {
    try (MechServerProcess server =
            MechServerProcess.start(new ServerSettings("s", "127.0.0.1", 0, 1));
        ServiceJvm host = ServiceJvm.host(server.url(), "far", "--capacity", "1");
        MechConnection connection = MechConnection.open(server.url())) {
      Taker undisturbed = new Taker(() -> {});
      try (MechSession session = connection.openSession("s")) {
        session.loadModel(Runs.PENDULUM);
        try (RemoteRun run = session.prepareRemoteRun(LONG)) {
          run.toEnd(undisturbed);
        }
      }
      List<String> told = new CopyOnWriteArrayList<>();
      RunListener listener = keptIn(told);
      Taker taken = new Taker(host::kill);
      try (MechSession session = connection.openSession("far")) {
        session.loadModel(Runs.PENDULUM);
        try (RemoteRun run = session.prepareRemoteRun(LONG, listener)) {
          RunResult result = run.toEnd(taken);
          assertThat(result.outcome()).isInstanceOf(Outcome.Completed.class);
          assertThat(result.report().get("where"))
              .isEqualTo("remote, host s from its start, after host far was lost");
        }
      }
      assertThat(taken.rows).isEqualTo(undisturbed.rows).isEqualTo(50_001);
      assertThat(taken.bits).isEqualTo(undisturbed.bits);
      assertThat(told).anyMatch(text -> text.contains("S-118 host far was lost"));
    }
  }

  @Test
  void runWhoseWorkerIsKilledIsComputedAgainToTheSameBits() throws Exception {
    SimulationOptions options = SimulationOptions.asInFile().endTime(80).outputStep(0.01);
    HostOptions host =
        new HostOptions("s", 1, HostLimits.DEFAULT, Optional.empty(), UserCodePolicy.UNCONFINED);
    try (MechServerProcess server =
            MechServerProcess.start(new ServerSettings("127.0.0.1", 0, host));
        MechConnection connection = MechConnection.open(server.url());
        MechSession session = connection.openSession()) {
      session.loadModel(USER_FORCES, UserCode.in(USER_FORCES.resolveSibling(".")));
      Taker undisturbed = new Taker(() -> {});
      try (RemoteRun run = session.prepareRemoteRun(options)) {
        run.toEnd(undisturbed);
      }
      List<String> told = new CopyOnWriteArrayList<>();
      Taker taken = new Taker(LostHostTest::killWorkers);
      try (RemoteRun run = session.prepareRemoteRun(options, keptIn(told))) {
        assertThat(run.toEnd(taken).outcome()).isInstanceOf(Outcome.Completed.class);
      }
      assertThat(taken.rows).isEqualTo(undisturbed.rows).isEqualTo(8001);
      assertThat(taken.bits).isEqualTo(undisturbed.bits);
      assertThat(told).anyMatch(text -> text.contains("S-118"));
    }
  }

  private static RunListener keptIn(List<String> told) {
    return new RunListener() {
      @Override
      public void onMessages(List<ModelMessage> messages) {
        messages.forEach(message -> told.add(message.toString()));
      }
    };
  }

  /** Ends those in which the users' forces are computed. */
  private static void killWorkers() {
    List<ProcessHandle> workers =
        ProcessHandle.current().descendants().filter(ServiceJvm::isWorker).toList();
    assertThat(workers).isNotEmpty();
    workers.forEach(ProcessHandle::destroyForcibly);
  }

  @Test
  void hostThatIsTerminatedPassesItsRunsOnBeforeItEnds() throws Exception {
    try (MechServerProcess server =
            MechServerProcess.start(new ServerSettings("s", "127.0.0.1", 0, 1));
        ServiceJvm host = ServiceJvm.host(server.url(), "far", "--capacity", "1", "--grace", "60");
        MechConnection connection = MechConnection.open(server.url());
        MechSession session = connection.openSession("far")) {
      session.loadModel(Runs.PENDULUM);
      List<String> told = new CopyOnWriteArrayList<>();
      List<Integer> status = new CopyOnWriteArrayList<>();
      RunListener listener = keptIn(told);
      RemoteRun run = session.prepareRemoteRun(ENDLESS, listener);
      try (run) {
        RunResult result = run.toEnd(new Taker(() -> terminateThenCancel(host, status, run)));
        assertThat(result.outcome()).isInstanceOf(Outcome.Stopped.class);
      }
      assertThat(status).containsExactly(143);
      assertThat(told)
          .anyMatch(text -> text.contains("S-117 the run goes on on host s"))
          .noneMatch(text -> text.contains("S-118"));
    }
  }

  private static void terminateThenCancel(ServiceJvm host, List<Integer> status, RemoteRun run) {
    Thread thread =
        new Thread(
            () -> {
              try {
                status.add(host.terminate());
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
              run.cancel();
            });
    thread.start();
  }

  @Test
  void hostWhoseRunsCannotMoveEndsWhenItsGraceIsOver() throws Exception {
    try (MechServerProcess server =
            MechServerProcess.start(new ServerSettings("s", "127.0.0.1", 0, 0));
        ServiceJvm host = ServiceJvm.host(server.url(), "far", "--capacity", "1", "--grace", "1");
        ServiceOrb orb = ServiceOrb.client();
        MechConnection connection = MechConnection.open(server.url());
        MechSession session = connection.openSession()) {
      session.loadModel(Runs.PENDULUM);
      try (RemoteRun run = session.prepareRemoteRun(ENDLESS)) {
        run.start();
        awaitRows(orb.connectAdmin(server.url()));
        assertThat(host.terminate()).isEqualTo(143);
        assertThat(host.messages()).doesNotContain("S-001").doesNotContain("not closed within");
      }
    }
  }

  @Test
  void simulateOfALostServerSaysHowItsRowsAreFetched(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("r.csv");
    StringWriter err = new StringWriter();
    try (ServiceJvm server = ServiceJvm.server(256, "--spool", folder.resolve("spool").toString());
        ServiceOrb orb = ServiceOrb.client()) {
      MechAdmin admin = orb.connectAdmin(server.address());
      List<Integer> status = new ArrayList<>();
      Thread simulate = new Thread(() -> status.add(simulateForLong(server.address(), file, err)));
      simulate.start();
      SimSummary run = awaitRows(admin);
      server.kill();
      simulate.join();
      assertThat(status).containsExactly(3);
      assertThat(err.toString())
          .contains("mech fetch " + run.simId + " --server " + server.address())
          .contains("; rows up to t=");
      assertThat(Files.readString(file)).startsWith("t,");
    }
  }

  @Test
  void simulateThatAnOperatorStopsSaysWhy(@TempDir Path folder) throws Exception {
    StringWriter err = new StringWriter();
    try (MechServerProcess server =
            MechServerProcess.start(new ServerSettings("s", "127.0.0.1", 0, 1));
        ServiceOrb orb = ServiceOrb.client()) {
      MechAdmin admin = orb.connectAdmin(server.url());
      List<Integer> status = new ArrayList<>();
      Thread simulate =
          new Thread(() -> status.add(simulateForLong(server.url(), folder.resolve("r.csv"), err)));
      simulate.start();
      admin.killSimulation(awaitRows(admin).simId, "maintenance");
      simulate.join();
      assertThat(status).containsExactly(130);
      assertThat(err.toString())
          .contains("S-018 cancelled by the operator: maintenance")
          .contains("S-045 the run was stopped at t=");
    }
  }

  private static int simulateForLong(String server, Path file, StringWriter err) {
    return Mech.run(
        new PrintWriter(new StringWriter()),
        new PrintWriter(err, true),
        "simulate",
        Runs.PENDULUM.toString(),
        "--server",
        server,
        "--t-end",
        "1e7",
        "--t-step",
        "5",
        "--out",
        file.toString());
  }

  private static SimSummary awaitRows(MechAdmin admin) throws Exception {
    while (true) {
      for (SimSummary run : admin.listSimulations(0, 10, new IntHolder())) {
        if (run.info.state == SimState.SIM_RUNNING && run.info.rowsReady > 100) {
          return run;
        }
      }
      Thread.sleep(50);
    }
  }
}
