package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.mechservice.sim.service.session.HostedClient.ALL;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.SimState;
import org.mechservice.orb.testing.CursorRows;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.testing.PacedSolver;
import org.mechservice.solver.api.Solver;
import org.omg.CORBA.UserException;

/** Every limit stops what is beyond it, under its own code and name, and nothing else. */
@Tag("slow")
class LimitsTest {
  /** Asks a host for one thing too many. */
  private interface Demand {
    ThrowingCallable of(HostedClient there) throws Exception;
  }

  private static HostedClient with(HostLimit limit, long value) {
    return with(limit, value, PacedSolver.endless());
  }

  private static HostedClient with(HostLimit limit, long value, Solver solver) {
    return new HostedClient(solver, HostLimits.DEFAULT.with(limit, value), 1);
  }

  private static LimitExceeded refusal(HostLimit limit, long value, String code, Demand demand)
      throws Exception {
    try (HostedClient there = with(limit, value)) {
      LimitExceeded refusal = catchThrowableOfType(LimitExceeded.class, demand.of(there));
      assertThat(refusal).isNotNull();
      assertThat(refusal.code).isEqualTo(code);
      assertThat(refusal.limitName).isEqualTo(limit.label());
      assertThat(refusal.limitValue).isEqualTo(value);
      assertThat(refusal.requested).isGreaterThan(value);
      return refusal;
    }
  }

  private static ThrowingCallable simulationIn(MechSim session) {
    return () -> session.createSimulation(new NameValue[0], null);
  }

  @Test
  void sessions() throws Exception {
    LimitExceeded refusal =
        refusal(
            HostLimit.SESSIONS,
            2,
            "S-100",
            there -> {
              there.emptySession();
              there.emptySession();
              return there::emptySession;
            });
    assertThat(refusal.text).isEqualTo("no more than 2 sessions on one host at once");
  }

  /** Others still get in. */
  @Test
  void sessionsOfOneClient() throws Exception {
    LimitExceeded refusal =
        refusal(
            HostLimit.CLIENT_SESSIONS,
            2,
            "S-100",
            there -> {
              there.emptySession();
              there.emptySession();
              there.host.createSession("somebody else", null);
              return there::emptySession;
            });
    assertThat(refusal.text).isEqualTo("no more than 2 sessions of one client on one host at once");
  }

  @Test
  void bytesOfAllModelsOfOneClient() throws Exception {
    LimitExceeded refusal =
        refusal(
            HostLimit.CLIENT_MODEL_BYTES,
            2L * HostedClient.pendulum().content.length - 1,
            "S-105",
            there -> {
              there.session();
              return there::session;
            });
    assertThat(refusal.text).contains("the models of your sessions and simulations would have");
  }

  /** A simulation holds its model after its session has loaded another one. */
  @Test
  void bytesOfTheModelsOfAllSimulationsOfOneClient() throws Exception {
    refusal(
        HostLimit.CLIENT_MODEL_BYTES,
        3L * HostedClient.pendulum().content.length - 1,
        "S-105",
        there -> {
          MechSim session = there.session();
          session.createSimulation(new NameValue[0], null);
          return simulationIn(session);
        });
  }

  /** A million empty files are a message of some megabytes. */
  @Test
  void filesOfAModel() throws Exception {
    ModelFile[] empty = new ModelFile[1000];
    Arrays.setAll(empty, i -> new ModelFile("C" + i + ".java", new byte[0]));
    refusal(
        HostLimit.MODEL_BYTES,
        100_000,
        "S-105",
        there -> {
          MechSim session = there.emptySession();
          return () -> session.loadModel(HostedClient.pendulum(), empty);
        });
  }

  @Test
  void foreseeableRowsOfAllRunsOfOneClient() throws Exception {
    refusal(HostLimit.CLIENT_SPOOL_BYTES, 20_000, "S-107", there -> simulationIn(there.session()));
  }

  @Test
  void rowsOfAllRunsOfOneClientThatNobodyForesaw() throws Exception {
    FailureRecord failure =
        failureAt(HostLimit.CLIENT_SPOOL_BYTES, 100_000, new PacedSolver(100_000, 0));
    assertThat(failure.code).isEqualTo("S-107");
    assertThat(failure.text).contains("of one client");
  }

  @Test
  void simulationsOfOneSession() throws Exception {
    LimitExceeded refusal =
        refusal(
            HostLimit.SIMULATIONS,
            1,
            "S-101",
            there -> {
              MechSim session = there.session();
              session.createSimulation(new NameValue[0], null);
              return simulationIn(session);
            });
    assertThat(refusal.text).isEqualTo("no more than 1 simulations of one session at once");
  }

  @Test
  void runsOfOneClientInAllItsSessions() throws Exception {
    refusal(
        HostLimit.CLIENT_RUNS,
        2,
        "S-102",
        there -> {
          there.simulation();
          there.simulation();
          return simulationIn(there.session());
        });
  }

  @Test
  void cursorsOfOneSimulation() throws Exception {
    refusal(
        HostLimit.CURSORS,
        1,
        "S-103",
        there -> {
          IMechSimRemote run = there.simulation();
          run.openResults(ALL);
          return () -> run.openResults(ALL);
        });
  }

  @Test
  void runsThatWait() throws Exception {
    LimitExceeded refusal =
        refusal(
            HostLimit.QUEUE,
            1,
            "S-104",
            there -> {
              IMechSimRemote first = there.simulation();
              first.start();
              Eventually.holds(() -> first.getProgress().state == SimState.SIM_RUNNING);
              there.simulation().start();
              return there.simulation()::start;
            });
    assertThat(refusal.text).contains("no more than 1 runs that wait");
  }

  @Test
  void bytesOfAModel() throws Exception {
    LimitExceeded refusal =
        refusal(
            HostLimit.MODEL_BYTES,
            100,
            "S-105",
            there -> {
              MechSim session = there.emptySession();
              return () -> session.loadModel(HostedClient.pendulum(), new ModelFile[0]);
            });
    assertThat(refusal.requested).isEqualTo(HostedClient.pendulum().content.length);
  }

  @Test
  void foreseeableRowsOfOneRun() throws Exception {
    LimitExceeded refusal =
        refusal(HostLimit.RESULT_BYTES, 20_000, "S-106", there -> simulationIn(there.session()));
    assertThat(refusal.text).contains("make t-step larger or choose fewer columns");
  }

  @Test
  void foreseeableRowsOfAllRuns() throws Exception {
    refusal(HostLimit.SPOOL_BYTES, 20_000, "S-107", there -> simulationIn(there.session()));
  }

  @Test
  void connections() throws Exception {
    refusal(
        HostLimit.CONNECTIONS,
        1,
        "S-111",
        there -> {
          there.emptySession().sessionId(); // opens the client's connection
          return there::emptySession;
        });
  }

  @Test
  void memoryOfTheHost() throws Exception {
    refusal(
        HostLimit.MEMORY,
        1,
        "S-110",
        there -> {
          System.gc(); // what is in use is known after a collection
          return simulationIn(there.session());
        });
  }

  /** What a client calls itself and its files is in each event and list, and in each message. */
  @Test
  void namesOfAClientAndItsFilesAreShort() throws Exception {
    String name = "ann\n\u001b]0;x\u0007" + "x".repeat(5_000_000);
    try (HostedClient there = with(HostLimit.SESSIONS, 5)) {
      MechSim session = there.host.createSession(name, null);
      assertThat(there.host.listSessions()[0].owner).startsWith("ann??]0;x?x").hasSize(203);
      assertThat(there.host.events(0, 10, 0)[0].text.length()).isLessThan(500);
      ModelFile wrong = new ModelFile(name, "no model".getBytes(StandardCharsets.UTF_8));
      InvalidModel refusal =
          catchThrowableOfType(
              InvalidModel.class,
              () -> there.seenByClient(session).loadModel(wrong, new ModelFile[0]));
      assertThat(refusal.diagnostics[0].text.length()).isLessThan(500);
    }
  }

  /** Starts a run, waits for its end at a limit and returns its failure. */
  private static FailureRecord failureAt(HostLimit limit, long value, Solver solver)
      throws Exception {
    try (HostedClient there = with(limit, value, solver)) {
      IMechSimRemote run = there.simulation();
      run.start();
      Eventually.holds(() -> run.getProgress().state == SimState.SIM_FAILED);
      FailureRecord failure = run.failure();
      assertThat(failure.code).isEqualTo(limit.code().code());
      assertThat(failure.advice).contains("the operator can raise the limit \"" + limit.label());
      assertThat(run.getProgress().rowsReady).isPositive();
      assertThat(run.report()).contains("\"outcome\":\"failed\"").contains(limit.code().code());
      assertRowsAreKept(run);
      return failure;
    }
  }

  private static void assertRowsAreKept(IMechSimRemote run) throws UserException {
    long rows = run.getProgress().rowsReady;
    assertThat(CursorRows.toEnd(run.openResults(new String[] {"t"}), 0))
        .hasSize(Math.toIntExact(rows));
  }

  /** A file of a kilobyte can ask for any number of rows, and a host is there for many. */
  @Test
  void runsAreBoundedUnlessTheOperatorSaysOtherwise() throws Exception {
    for (HostLimit limit :
        List.of(
            HostLimit.WALL_TIME,
            HostLimit.CPU_TIME,
            HostLimit.MEMORY,
            HostLimit.WORKER_MEMORY,
            HostLimit.RESULT_BYTES)) {
      assertThat(HostLimits.DEFAULT.of(limit)).as(limit.label()).isPositive();
      assertThat(HostLimits.OWN.of(limit)).as(limit.label()).isEqualTo(HostLimits.UNLIMITED);
    }
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      NameValue[] longRun = {new NameValue("t-end", "200000"), new NameValue("t-step", "0.001")};
      LimitExceeded refusal =
          catchThrowableOfType(LimitExceeded.class, () -> there.simulation(longRun));
      assertThat(refusal.code).isEqualTo("S-106");
      assertThat(refusal.limitName).isEqualTo("resultBytes");
    }
  }

  @Test
  void timeOfARun() throws Exception {
    FailureRecord failure = failureAt(HostLimit.WALL_TIME, 1, PacedSolver.endless());
    assertThat(failure.code).isEqualTo("S-108");
    assertThat(failure.text).contains("used up the 1 s of time");
  }

  @Test
  void processorTimeOfARun() throws Exception {
    FailureRecord failure = failureAt(HostLimit.CPU_TIME, 1, PacedSolver.busy());
    assertThat(failure.code).isEqualTo("S-109");
    assertThat(failure.text).contains("used up the 1 s of processor time");
  }

  @Test
  void rowsOfOneRunThatNobodyForesaw() throws Exception {
    FailureRecord failure = failureAt(HostLimit.RESULT_BYTES, 100_000, new PacedSolver(100_000, 0));
    assertThat(failure.code).isEqualTo("S-106");
    assertThat(failure.text).contains("more than the 0.1 MB this host keeps of one");
  }

  @Test
  void rowsOfAllRunsThatNobodyForesaw() throws Exception {
    FailureRecord failure = failureAt(HostLimit.SPOOL_BYTES, 100_000, new PacedSolver(100_000, 0));
    assertThat(failure.code).isEqualTo("S-107");
    assertThat(failure.text).contains("destroy runs that are no longer needed");
  }
}
