package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.mechservice.sim.service.session.HostedClient.ALL;
import static org.mechservice.sim.service.session.HostedClient.COLUMNS;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.IMechSimRemoteHelper;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ResultBlockHolder;
import org.mechservice.idl.ResultCursor;
import org.mechservice.idl.SimState;
import org.mechservice.orb.testing.CursorRows;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.testing.PacedSolver;
import org.mechservice.solver.api.Solver;
import org.omg.CORBA.UserException;

/** Who cancels or destroys a run waits neither for its solver nor for a disk. */
@Tag("slow")
class CancelContractTest {
  @TempDir private Path folder;

  @Test
  void cancelIsAnsweredAndLeavesTheRows() throws UserException {
    try (HostedClient there = HostedClient.with(PacedSolver.endless())) {
      IMechSimRemote run = there.simulation();
      run.start();
      ResultCursor cursor = run.openResults(ALL);
      ResultBlockHolder block = new ResultBlockHolder();
      while (!cursor.nextBlock(0, 1000, block)) {
        assertThat(block.value.endOfData).isFalse();
      }
      run.cancel();
      run.cancel();
      cursor.seekRow(0);
      List<double[]> rows = CursorRows.toEnd(cursor, 0);
      assertThat(rows).isNotEmpty();
      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_CANCELLED);
      assertThat(run.report()).contains("\"outcome\":\"stopped\"");
    }
  }

  /** As in the factorisation of a large matrix, or in a force that computes for long. */
  @Test
  void cancelDoesNotWaitForASolverDeepInOneEvaluation() throws Exception {
    CountDownLatch evaluationEnds = new CountDownLatch(1);
    CountDownLatch lateRowRefused = new CountDownLatch(1);
    Solver deep =
        (model, request, sink, control) -> {
          double[] row = new double[COLUMNS];
          sink.row(row);
          control.proceed(0.5, 0.5, 1, 1);
          await(evaluationEnds);
          try {
            sink.row(row);
          } catch (IOException refused) {
            lateRowRefused.countDown();
          }
          throw new IOException("nobody hears of this");
        };
    try (HostedClient there = HostedClient.with(deep)) {
      IMechSimRemote run = there.simulation();
      run.start();
      Eventually.holds(() -> run.getProgress().stepsDone == 1);
      run.cancel();
      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_CANCELLED);
      assertThat(run.report()).contains("\"outcome\":\"stopped\"", "\"steps\":1", "\"rows\":1");
      evaluationEnds.countDown();
      await(lateRowRefused);
      assertThat(CursorRows.toEnd(run.openResults(ALL), 0)).hasSize(1);
      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_CANCELLED);
    }
  }

  private static void await(CountDownLatch latch) {
    try {
      assertThat(latch.await(60, TimeUnit.SECONDS)).isTrue();
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void heldRunIsCancelledToo() throws UserException {
    try (HostedClient there = HostedClient.with(PacedSolver.endless())) {
      IMechSimRemote run = there.simulation();
      run.stepOnce();
      run.cancel();
      CursorRows.toEnd(run.openResults(ALL), 0);
      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_CANCELLED);
    }
  }

  private HostedClient withFolder(Solver solver) {
    return new HostedClient(
        solver, new HostOptions("here", 2, HostLimits.DEFAULT, Optional.of(folder)));
  }

  /** A pipe that nobody reads: who opens it to write waits. */
  private Path diskThatDoesNotAnswer(IMechSimRemote run) throws Exception {
    Path pipe = folder.resolve(run.simId() + ".part");
    assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
    return pipe;
  }

  private void answerAgain(Path pipe) throws IOException {
    Path aside = Files.move(pipe, folder.resolve("aside"));
    try (InputStream in = Files.newInputStream(aside)) {
      in.readAllBytes();
    }
    Files.delete(aside);
  }

  private List<String> endingsInFolder() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .map(file -> file.getFileName().toString().replaceAll("[^.]*[.]", "."))
          .sorted()
          .toList();
    }
  }

  @Test
  void cancelDoesNotWaitForADiskThatDoesNotAnswer() throws Exception {
    String simId;
    try (HostedClient there = withFolder(PacedSolver.endless())) {
      IMechSimRemote run = there.simulation();
      simId = run.simId();
      Path pipe = diskThatDoesNotAnswer(run);
      run.start();
      Eventually.holds(() -> run.getProgress().state == SimState.SIM_RUNNING);
      run.cancel();
      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_CANCELLED);
      assertThat(run.report()).contains("\"outcome\":\"stopped\"");
      answerAgain(pipe);
    }
    assertThat(stateAfterRestart(simId)).isEqualTo(SimState.SIM_CANCELLED);
  }

  @Test
  void destroyDoesNotWaitForADiskThatDoesNotAnswer() throws Exception {
    try (HostedClient there = withFolder(PacedSolver.endless())) {
      IMechSimRemote run = there.simulation();
      String simId = run.simId();
      Path pipe = diskThatDoesNotAnswer(run);
      run.start();
      Eventually.holds(() -> run.getProgress().state == SimState.SIM_RUNNING);
      run.destroy();
      assertThat(there.host.showSimulation(simId).summary.info.state)
          .isEqualTo(SimState.SIM_CANCELLED);
      answerAgain(pipe);
    }
    assertThat(endingsInFolder()).containsExactly("lock");
  }

  @Test
  void cancelledRunOutlivesItsProcessWithItsRows() throws Exception {
    String simId;
    int rows;
    try (HostedClient there = withFolder(PacedSolver.endless())) {
      IMechSimRemote run = there.simulation();
      simId = run.simId();
      run.start();
      Eventually.holds(() -> run.getProgress().rowsReady > 0);
      run.cancel();
      rows = CursorRows.toEnd(run.openResults(ALL), 0).size();
    }
    assertThat(rows).isPositive();
    try (HostedClient after = withFolder(PacedSolver.endless())) {
      IMechSimRemote run = found(after, simId);
      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_CANCELLED);
      assertThat(run.report()).contains("\"outcome\":\"stopped\"");
      assertThat(CursorRows.toEnd(run.openResults(ALL), 0)).hasSize(rows);
    }
  }

  /** As with a process that is killed while the disk is slow: nothing is ever forced there. */
  @Test
  void runIsCancelledOnDiskBeforeTheDiskHasConfirmedItsRows() throws Exception {
    String simId;
    try (HostedClient there = withFolder(PacedSolver.endless())) {
      IMechSimRemote run = there.simulation();
      simId = run.simId();
      Files.createSymbolicLink(folder.resolve(simId + ".rows"), Path.of("/dev/null"));
      run.start();
      Eventually.holds(() -> run.getProgress().rowsReady > 0);
      run.cancel();
    }
    assertThat(stateAfterRestart(simId)).isEqualTo(SimState.SIM_CANCELLED);
  }

  private SimState stateAfterRestart(String simId) throws Exception {
    try (HostedClient after = withFolder(PacedSolver.endless())) {
      return found(after, simId).getProgress().state;
    }
  }

  private static IMechSimRemote found(HostedClient there, String simId) throws Exception {
    return IMechSimRemoteHelper.unchecked_narrow(
        there.clientOrb.fromIor(there.hostOrb.toIor(there.host.findSimulation(simId, ""))));
  }

  @Test
  void runDestroyedInMidCourseLeavesNothing() throws Exception {
    String simId;
    try (HostedClient there = withFolder(PacedSolver.endless())) {
      IMechSimRemote run = there.simulation();
      simId = run.simId();
      run.start();
      Eventually.holds(() -> run.getProgress().rowsReady > 0);
      run.destroy();
      assertThatThrownBy(() -> there.host.findSimulation(simId, "")).isInstanceOf(NotFound.class);
    }
    assertThat(endingsInFolder()).containsExactly("lock");
  }
}
