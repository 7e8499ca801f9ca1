package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.mechservice.sim.service.session.HostedClient.ALL;
import static org.mechservice.sim.service.session.HostedClient.COLUMNS;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MAX_BLOCK_DOUBLES;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.Progress;
import org.mechservice.idl.ResultBlockHolder;
import org.mechservice.idl.ResultCursor;
import org.mechservice.idl.SimState;
import org.mechservice.orb.testing.CursorRows;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.testing.PacedSolver;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.simulation.SolverVersion;
import org.omg.CORBA.DoubleHolder;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.CORBA.UserException;

@Tag("slow")
class SimulationContractTest {
  @Test
  void pendulumRunsToItsEnd() throws UserException {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      IMechSimRemote run = there.simulation();
      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_CREATED);
      run.start();
      List<double[]> rows = CursorRows.toEnd(run.openResults(ALL), 0);
      assertThat(rows).hasSize(301);
      assertThat(rows.get(300)[0]).isEqualTo(3);
      Progress end = run.getProgress();
      assertThat(end.state).isEqualTo(SimState.SIM_DONE);
      assertThat(end.simTime).isEqualTo(3);
      assertThat(end.rowsReady).isEqualTo(301);
    }
  }

  @Test
  void reportTellsWhatTheSolverAndTheServiceKnow() throws UserException {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      IMechSimRemote run = there.simulation(new NameValue("rtol", "1e-7"));
      run.start();
      CursorRows.toEnd(run.openResults(ALL), 0);
      JsonObject report = JsonParser.parseString(run.report()).getAsJsonObject();
      assertThat(report.get("scene").getAsString()).isEqualTo("FiveBarPendulum");
      assertThat(report.get("relativeTolerance").getAsDouble()).isEqualTo(1e-7);
      assertThat(report.get("where").getAsString()).isEqualTo("remote, host here");
      assertThat(report.get("modelSha256").getAsString()).hasSize(64);
      assertThat(report.keySet()).contains("t1s", "tcc", "formulationReason", "serverVersion");
    }
  }

  @Test
  void rowsAreTheSameStepByStepInBlocksAndAtTheEnd() throws UserException {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      IMechSimRemote run = there.simulation();
      ResultCursor openedBefore = run.openResults(ALL);
      run.start();
      List<double[]> stepByStep = CursorRows.toEnd(openedBefore, 1);
      List<double[]> inBlocks = CursorRows.toEnd(run.openResults(ALL), 17);
      List<double[]> atTheEnd = CursorRows.toEnd(run.openResults(ALL), 0);
      assertThat(inBlocks).usingElementComparator(Arrays::compare).isEqualTo(stepByStep);
      assertThat(atTheEnd).usingElementComparator(Arrays::compare).isEqualTo(stepByStep);
    }
  }

  @Test
  void cursorHandsOutTheChannelsAskedFor() throws UserException {
    try (HostedClient there = HostedClient.with(new PacedSolver(5, 0))) {
      IMechSimRemote run = there.simulation(new NameValue("columns", "energy"));
      run.start();
      ResultCursor cursor = run.openResults(new String[] {"j2.q", "t", "energy"});
      assertThat(Arrays.stream(cursor.channels()).map(channel -> channel.name + " " + channel.unit))
          .containsExactly(
              "j2.q rad", "t s", "energy.kinetic J", "energy.potential J", "energy.work J");
      assertThat(CursorRows.toEnd(cursor, 0).get(3)).containsExactly(3002, 3, 3011, 3012, 3013);
    }
  }

  @Test
  void blocksStayBelowTheSizeOfTheContract() throws UserException {
    int rowsOfBlock = MAX_BLOCK_DOUBLES.value / COLUMNS;
    try (HostedClient there = HostedClient.with(new PacedSolver(rowsOfBlock + 10L, 0))) {
      IMechSimRemote run = there.simulation();
      run.start();
      ResultCursor cursor = run.openResults(ALL);
      assertThat(CursorRows.toEnd(cursor, 1)).hasSize(rowsOfBlock + 10);
      cursor.seekRow(0);
      ResultBlockHolder block = new ResultBlockHolder();
      assertThat(cursor.nextBlock(-1, 0, block)).isTrue(); // unsigned: as many as there are
      assertThat(block.value.rowCount).isEqualTo(rowsOfBlock);
      assertThat(block.value.endOfData).isFalse();
      assertThat(cursor.nextBlock(-1, 0, block)).isTrue();
      assertThat(block.value.firstRow).isEqualTo(rowsOfBlock);
      assertThat(block.value.rowCount).isEqualTo(10);
      assertThat(block.value.endOfData).isTrue();
      assertThat(cursor.nextBlock(-1, 0, block)).isFalse();
    }
  }

  @Test
  void seekingGoesToAnyRowThereIs() throws UserException {
    try (HostedClient there = HostedClient.with(new PacedSolver(100, 0))) {
      IMechSimRemote run = there.simulation();
      run.start();
      ResultCursor cursor = run.openResults(new String[] {"t"});
      CursorRows.toEnd(cursor, 0);
      cursor.seekRow(97);
      assertThat(CursorRows.toEnd(cursor, 0).stream().map(row -> row[0]))
          .containsExactly(97.0, 98.0, 99.0);
      assertThatThrownBy(() -> cursor.seekRow(101)).isInstanceOf(NotFound.class);
      assertThatThrownBy(() -> cursor.seekRow(-1)).isInstanceOf(NotFound.class);
    }
  }

  /** The call that holds a run waits a second for it; a machine under heavy load takes longer. */
  private static void awaitPause(IMechSimRemote run) throws Exception {
    Eventually.holds(() -> run.getProgress().state == SimState.SIM_PAUSED);
  }

  @Test
  void stepsAreTakenOneByOne() throws Exception {
    try (HostedClient there = HostedClient.with(new PacedSolver(1000, 0))) {
      IMechSimRemote run = there.simulation();
      for (int step = 1; step <= 50; step++) {
        run.stepOnce();
        awaitPause(run);
        assertThat(run.getProgress().stepsDone).isEqualTo(step);
      }
      DoubleHolder time = new DoubleHolder();
      assertThat(run.getStates(time)).hasSize(10).startsWith(50_001, 50_002);
      assertThat(time.value).isEqualTo(50);
      run.resume();
      assertThat(CursorRows.toEnd(run.openResults(ALL), 0)).hasSize(1000);
    }
  }

  @Test
  void runIsHeldAtTheTimeAskedFor() throws UserException {
    try (HostedClient there = HostedClient.with(PacedSolver.endless())) {
      IMechSimRemote run = there.simulation();
      run.runTo(20);
      ResultBlockHolder block = new ResultBlockHolder();
      ResultCursor cursor = run.openResults(ALL);
      for (int rows = 0; rows <= 20; rows += block.value.rowCount) {
        cursor.nextBlock(0, 1000, block);
      }
      run.pause();
      assertThat(run.getProgress().simTime).isEqualTo(20);
    }
  }

  @Test
  void runsBeyondTheCapacityWaitTheirTurn() throws Exception {
    try (HostedClient there = new HostedClient(PacedSolver.endless(), HostLimits.DEFAULT, 1)) {
      MechSim session = there.session();
      IMechSimRemote first = session.createSimulation(new NameValue[0], null);
      IMechSimRemote second = session.createSimulation(new NameValue[0], null);
      IMechSimRemote third = session.createSimulation(new NameValue[0], null);
      first.stepOnce();
      awaitPause(first);
      second.start();
      third.start();
      assertThat(second.getProgress().state).isEqualTo(SimState.SIM_QUEUED);
      assertThat(third.getProgress().queuePosition).isEqualTo(2);
      String waiting = third.simId();
      Eventually.holds(
          () ->
              Arrays.stream(session.pollEvents(0, 500, 0))
                  .anyMatch(
                      event -> event.info.simId.equals(waiting) && event.info.queuePosition == 2));
      second.cancel();
      assertThat(second.getProgress().state).isEqualTo(SimState.SIM_CANCELLED);
      assertThat(third.getProgress().queuePosition).isEqualTo(1);
      first.cancel();
      third.pause();
      awaitPause(third);
    }
  }

  @Test
  void whatDoesNotFitTheStateIsRefused() throws UserException {
    try (HostedClient there = HostedClient.with(new PacedSolver(3, 0))) {
      IMechSimRemote run = there.simulation();
      assertThatThrownBy(run::pause).isInstanceOf(InvalidState.class);
      assertThatThrownBy(run::resume).isInstanceOf(InvalidState.class);
      assertThatThrownBy(run::report).isInstanceOf(InvalidState.class);
      assertThatThrownBy(() -> run.runTo(Double.NaN)).isInstanceOf(InvalidState.class);
      run.start();
      CursorRows.toEnd(run.openResults(ALL), 0);
      InvalidState refusal = catchThrowableOfType(InvalidState.class, run::start);
      assertThat(refusal.current).isEqualTo(SimState.SIM_DONE);
      assertThat(refusal.code).isEqualTo("S-009");
      assertThatThrownBy(run::stepOnce).isInstanceOf(InvalidState.class);
      assertThatThrownBy(run::failure).isInstanceOf(InvalidState.class);
    }
  }

  @Test
  void runWhoseRowsCannotBeKeptFailsWithItsReason() throws UserException {
    Solver diskFull =
        (model, request, sink, control) -> {
          throw new IOException("no space left on device");
        };
    try (HostedClient there = HostedClient.with(diskFull)) {
      FailureRecord failure = failureOf(there);
      assertThat(failure.code).isEqualTo("S-014");
      assertThat(failure.text).contains("no space left on device");
    }
  }

  @Test
  void defectOfTheSolverIsAnIncidentWithoutJavaText() throws UserException {
    Solver broken =
        (model, request, sink, control) -> {
          throw new ArrayIndexOutOfBoundsException("secret");
        };
    try (HostedClient there = HostedClient.with(broken)) {
      FailureRecord failure = failureOf(there);
      assertThat(failure.code).isEqualTo("S-001");
      assertThat(failure.text)
          .contains("incident")
          .doesNotContain("secret")
          .doesNotContain("Array");
    }
  }

  @Test
  void refusalOfTheSolverKeepsItsCode() throws UserException {
    Solver refusing =
        (model, request, sink, control) -> {
          throw new IllegalArgumentException("S-062 the end time is odd");
        };
    try (HostedClient there = HostedClient.with(refusing)) {
      FailureRecord failure = failureOf(there);
      assertThat(failure.code).isEqualTo("S-062");
      assertThat(failure.text).isEqualTo("the end time is odd");
    }
  }

  @Test
  void stepsThatLedToAFailureReachTheClient() throws UserException {
    List<Failure.Step> steps =
        List.of(
            new Failure.Step(1, 1e-3, 4, 0.5, "accepted"),
            new Failure.Step(1.001, 1e-3, 4, Double.NaN, "a value was not finite"));
    Failure failed =
        new Failure(MessageCode.NOT_FINITE, "It is not finite.", 1.001, 1e-3, 4, "", "")
            .after(steps);
    Solver failing =
        (model, request, sink, control) ->
            new RunReport(
                new Outcome.Failed(failed),
                "Model",
                "DTR",
                request.settings(),
                1,
                1,
                4,
                0,
                1.001,
                0.1,
                OptionalDouble.empty(),
                OptionalDouble.empty(),
                false,
                SolverVersion.CURRENT);
    try (HostedClient there = HostedClient.with(failing)) {
      FailureRecord failure = failureOf(there);
      assertThat(failure.lastSteps).hasSize(2);
      assertThat(failure.lastSteps[0].errorRatio).isEqualTo(0.5);
      assertThat(failure.lastSteps[1].simTime).isEqualTo(1.001);
      assertThat(failure.lastSteps[1].errorRatio).isNaN();
    }
  }

  private static FailureRecord failureOf(HostedClient there) throws UserException {
    IMechSimRemote run = there.simulation();
    run.start();
    CursorRows.toEnd(run.openResults(ALL), 0);
    assertThat(run.getProgress().state).isEqualTo(SimState.SIM_FAILED);
    assertThat(run.report()).contains("\"outcome\":\"failed\"");
    return run.failure();
  }

  @Test
  void destroyedObjectsDoNotExist() throws UserException {
    try (HostedClient there = HostedClient.with(PacedSolver.endless())) {
      IMechSimRemote run = there.simulation();
      run.start();
      ResultCursor closed = run.openResults(ALL);
      ResultCursor left = run.openResults(ALL);
      closed.destroy();
      assertThatThrownBy(closed::channels).isInstanceOf(OBJECT_NOT_EXIST.class);
      assertThat(left.channels()).hasSize(COLUMNS);
      run.destroy();
      assertThatThrownBy(run::getProgress).isInstanceOf(OBJECT_NOT_EXIST.class);
      assertThatThrownBy(left::channels).isInstanceOf(OBJECT_NOT_EXIST.class);
      assertThat(there.host.getLoad().running).isZero();
    }
  }

  @Test
  void cursorsOfOneRunAreLimited() throws UserException {
    try (HostedClient there = HostedClient.with(new PacedSolver(3, 0))) {
      IMechSimRemote run = there.simulation();
      for (int i = 0; i < HostLimits.DEFAULT.of(HostLimit.CURSORS); i++) {
        run.openResults(ALL);
      }
      LimitExceeded refusal = catchThrowableOfType(LimitExceeded.class, () -> run.openResults(ALL));
      assertThat(refusal.limitName).isEqualTo("cursors");
    }
  }

  @Test
  void runWithMoreRowsThanTheHostKeepsIsRefusedBeforeItBegins() throws UserException {
    try (HostedClient there = HostedClient.with(new PacedSolver(3, 0))) {
      LimitExceeded refusal =
          catchThrowableOfType(
              LimitExceeded.class, () -> there.simulation(new NameValue("t-step", "1e-12")));
      assertThat(refusal.limitName).isEqualTo("resultBytes");
      assertThat(refusal.text).contains("t-step");
    }
  }

  @Test
  void clientOnAnotherThreadIsServedWhileOneWaitsForRows() throws Exception {
    try (HostedClient there = HostedClient.with(PacedSolver.endless())) {
      IMechSimRemote run = there.simulation();
      ResultCursor cursor = run.openResults(ALL);
      Thread waiting =
          new Thread(
              () -> {
                try {
                  CursorRows.toEnd(cursor, 0);
                } catch (UserException e) {
                  throw new IllegalStateException(e);
                }
              });
      waiting.start();
      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_CREATED);
      run.cancel();
      waiting.join();
      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_CANCELLED);
    }
  }
}
