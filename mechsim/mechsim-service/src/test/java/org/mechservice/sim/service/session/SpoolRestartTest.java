package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.mechservice.sim.service.session.HostedClient.ALL;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.IMechSimRemoteHelper;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.OPT_CONTINUES;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimState;
import org.mechservice.orb.testing.CursorRows;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.host.SimHost;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.results.ResultSpool;
import org.mechservice.sim.service.results.RunColumns;
import org.mechservice.sim.service.results.RunIdentity;
import org.mechservice.sim.service.results.RunRecord;
import org.mechservice.sim.service.results.RunStore;
import org.mechservice.sim.service.testing.PacedSolver;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.result.Variable;
import org.omg.CORBA.DoubleHolder;

/** What a host with a spool folder has written outlives its process. */
@Tag("slow")
class SpoolRestartTest {
  @TempDir private Path folder;

  private static HostedClient on(Path spool, Solver solver) {
    return new HostedClient(
        solver, new HostOptions("here", 1, HostLimits.DEFAULT, Optional.of(spool)));
  }

  private static IMechSimRemote found(HostedClient there, String simId) throws Exception {
    return IMechSimRemoteHelper.unchecked_narrow(
        there.clientOrb.fromIor(there.hostOrb.toIor(there.host.findSimulation(simId, ""))));
  }

  @Test
  void completedRunIsTakenUpAgainWithItsRowsStateAndReport() throws Exception {
    String simId;
    String report;
    List<double[]> rows;
    double[] state;
    try (HostedClient before = on(folder, SimHost.installedSolver())) {
      IMechSimRemote run = before.simulation();
      run.start();
      rows = CursorRows.toEnd(run.openResults(ALL), 0);
      report = run.report();
      state = run.getStates(new DoubleHolder());
      simId = run.simId();
    }
    try (HostedClient after = on(folder, SimHost.installedSolver())) {
      IMechSimRemote run = found(after, simId);
      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_DONE);
      assertThat(run.report()).isEqualTo(report);
      DoubleHolder time = new DoubleHolder();
      assertThat(run.getStates(time)).isEqualTo(state);
      assertThat(time.value).isEqualTo(3);
      assertThat(CursorRows.toEnd(run.openResults(ALL), 7))
          .usingElementComparator(Arrays::compare)
          .isEqualTo(rows);
      assertThatThrownBy(run::start).isInstanceOf(InvalidState.class);
    }
  }

  /** Rows and records are what others computed; also where the folder was open before. */
  @Test
  void othersMayNotReadTheFolderOrAnythingInIt() throws Exception {
    assumeTrue(
        folder.getFileSystem().supportedFileAttributeViews().contains("posix"),
        "no permissions on this system");
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxr-xr-x"));
    try (HostedClient there = on(folder, SimHost.installedSolver())) {
      IMechSimRemote run = there.simulation();
      run.start();
      CursorRows.toEnd(run.openResults(ALL), 0);
      Eventually.holds(() -> Files.exists(folder.resolve(run.simId() + ".json")));
      try (Stream<Path> files = Files.walk(folder)) {
        for (Path file : files.toList()) {
          assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
              .as(file.toString())
              .endsWith("------");
        }
      }
    }
  }

  /** As if its process had been killed then: what is in the file is all that is left. */
  @Test
  void fewRowsOfARunThatGoesOnAreOnDiskToo() throws Exception {
    try (HostedClient there = on(folder, PacedSolver.endless())) {
      IMechSimRemote run = there.simulation();
      Path rows = folder.resolve(run.simId() + ".rows");
      run.start();
      Eventually.holds(() -> run.getProgress().rowsReady > 0);
      run.pause();
      long bytes = run.getProgress().rowsReady * HostedClient.COLUMNS * Double.BYTES;
      Eventually.holds(() -> Files.exists(rows) && Files.size(rows) == bytes);
      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_PAUSED);
    }
  }

  @Test
  void runThatHasMovedHereIsFoundUnderItsEarlierIdsAlsoAfterARestart() throws Exception {
    NameValue moved = new NameValue(OPT_CONTINUES.value, "0a-1,0b-2");
    String simId;
    try (HostedClient before = on(folder, SimHost.installedSolver())) {
      IMechSimRemote run = before.simulation(moved);
      run.start();
      CursorRows.toEnd(run.openResults(ALL), 0);
      simId = run.simId();
      assertThat(found(before, "0b-2").simId()).isEqualTo(simId);
    }
    try (HostedClient after = on(folder, SimHost.installedSolver())) {
      assertThat(found(after, "0a-1").simId()).isEqualTo(simId);
      assertThatThrownBy(() -> found(after, "0a")).isInstanceOf(NotFound.class);
      assertThatThrownBy(
              () -> after.simulation(new NameValue(OPT_CONTINUES.value, "0a-1, everything")))
          .isInstanceOf(InvalidOption.class);
    }
  }

  @Test
  void runThatIsBeingReadOutlivesItsRetention() throws Exception {
    RunStore store = new RunStore(Optional.of(folder), inForce("retention", 0));
    RunIdentity identity =
        new RunIdentity("0a", "session", "here", "ann", "m", "m.xml", "", 0, List.of());
    RunColumns columns = new RunColumns(List.of(new Variable("t", "s")), List.of());
    ResultSpool rows = store.newRows("0a", "ann", 1);
    rows.append(new double[] {1});
    Progress done = new Progress("0a", SimState.SIM_DONE, 0, 1, 0, 1, 1, 1, 1, 1, 1);
    RunRecord run =
        new RunRecord(
            identity, columns, List.of(), done, 1, 1, "done", "{}", Optional.empty(), List.of());
    store.files("0a", rows).writeEnded(run);
    store.keep(run, rows);

    store.expire(simId -> simId.equals("0a"));
    assertThat(rows.read(0, 1)).containsExactly(1);
    store.expire(simId -> false);
    assertThatThrownBy(() -> rows.read(0, 1)).hasMessageContaining("deleted");
    store.close();
    assertThat(filesIn(folder)).containsExactly("lock");
  }

  @Test
  void clientAndOperatorHearThatACancelledRunCouldNotBeWrittenDown() throws Exception {
    try (HostedClient there = on(folder, SimHost.installedSolver())) {
      MechSim session = there.session();
      IMechSimRemote run = session.createSimulation(new NameValue[0], null);
      run.runTo(1);
      Eventually.holds(() -> run.getProgress().state == SimState.SIM_PAUSED);
      for (String name : filesIn(folder)) {
        Files.delete(folder.resolve(name));
      }
      Files.delete(folder);
      run.cancel();

      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_CANCELLED);
      Eventually.holds(
          () ->
              Stream.of(session.pollEvents(0, 100, 0))
                  .flatMap(event -> Stream.of(event.messages))
                  .anyMatch(message -> message.code.equals("S-014")));
      assertThat(there.host.events(0, 100, 0)).extracting(event -> event.code).contains("S-014");
    }
  }

  private static List<String> filesIn(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).toList();
    }
  }

  private static CurrentLimits inForce(String name, long value) {
    return new CurrentLimits(HostLimits.DEFAULT.with(name, value));
  }

  @Test
  void runDestroyedByItsClientIsGone() throws Exception {
    String simId;
    try (HostedClient before = on(folder, SimHost.installedSolver())) {
      IMechSimRemote run = before.simulation();
      run.start();
      CursorRows.toEnd(run.openResults(ALL), 0);
      simId = run.simId();
      run.destroy();
    }
    try (HostedClient after = on(folder, SimHost.installedSolver())) {
      assertThatThrownBy(() -> after.host.findSimulation(simId, "")).isInstanceOf(NotFound.class);
    }
    assertThat(filesIn(folder)).containsExactly("lock");
  }

  /** What is on disk at any moment is what a killed process leaves. */
  @Test
  void runCutOffIsReportedAsSuchWithItsRowsSoFar(@TempDir Path copy) throws Exception {
    String simId;
    try (HostedClient killed = on(folder, new PacedSolver(Long.MAX_VALUE, 0))) {
      IMechSimRemote run = killed.simulation();
      run.start();
      simId = run.simId();
      Eventually.holds(() -> run.getProgress().rowsReady > 10_000);
      copyFiles(folder, copy);
    }
    try (HostedClient after = on(copy, SimHost.installedSolver())) {
      IMechSimRemote run = found(after, simId);
      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_FAILED);
      assertThat(run.failure().code).isEqualTo("S-112");
      assertThat(run.failure().text).endsWith("its rows up to then are kept.");
      List<double[]> rows = CursorRows.toEnd(run.openResults(ALL), 0);
      assertThat(rows).hasSizeGreaterThan(1000);
      for (int i = 0; i < rows.size(); i++) {
        assertThat(rows.get(i)[0]).isEqualTo(i);
        assertThat(rows.get(i)[10]).isEqualTo(i * 1000.0 + 10);
      }
    }
  }

  private static void copyFiles(Path from, Path to) throws IOException {
    try (Stream<Path> files = Files.list(from)) {
      for (Path file : files.toList()) {
        Files.copy(file, to.resolve(file.getFileName()));
      }
    }
  }

  @Test
  void folderOfALivingHostIsRefused() {
    try (HostedClient first = on(folder, SimHost.installedSolver())) {
      assertThat(first.host.getInfo().name).isEqualTo("here");
      assertThatThrownBy(() -> on(folder, SimHost.installedSolver()))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageStartingWith("S-114")
          .hasMessageContaining("another host uses it");
    }
  }
}
