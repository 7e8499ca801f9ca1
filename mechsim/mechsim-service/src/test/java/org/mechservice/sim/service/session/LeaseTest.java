package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.mechservice.sim.service.session.HostedClient.ALL;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.ResultBlockHolder;
import org.mechservice.idl.ResultCursor;
import org.mechservice.orb.testing.CursorRows;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.testing.PacedSolver;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.CORBA.UserException;

@Tag("slow")
class LeaseTest {
  /** Models are read here: the start of another process may take longer than the lease. */
  private static final HostLimits BRIEF =
      HostLimits.DEFAULT
          .with(HostLimit.LEASE, 3)
          .with(HostLimit.SET_UP_MEMORY, HostLimits.UNLIMITED);

  @Test
  void deadClientsSessionIsEndedWithItsRunsAndFiles() throws Exception {
    try (HostedClient there = new HostedClient(PacedSolver.endless(), BRIEF, 2)) {
      IMechSimRemote run = there.simulation();
      run.start();
      run.openResults(ALL).nextBlock(0, 1000, new ResultBlockHolder());
      there.clientOrb.close();
      Eventually.holds(() -> there.host.getLoad().sessions == 0);
      Eventually.holds(() -> there.host.getLoad().running == 0);
      Eventually.holds(
          () -> namesOfThreads().stream().noneMatch(name -> name.contains("mechservice-run")));
      assertThat(there.host.logs(0, 100))
          .anySatisfy(line -> assertThat(line.text).contains("not renewed"));
    }
  }

  private static Set<String> namesOfThreads() {
    return Thread.getAllStackTraces().keySet().stream()
        .map(Thread::getName)
        .collect(Collectors.toSet());
  }

  @Test
  void anyCallToAnyObjectKeepsTheSession() throws Exception {
    try (HostedClient there = HostedClient.with(PacedSolver.endless())) {
      MechSim session = there.session();
      IMechSimRemote run = session.createSimulation(new NameValue[0], null);
      ResultCursor cursor = run.openResults(ALL);
      List<Runnable> calls =
          List.of(
              session::hostName,
              session::renewLease,
              run::getProgress,
              run::renewLease,
              cursor::channels,
              cursor::renewLease);
      for (Runnable call : calls) {
        long leaseEnd = leaseEnd(there);
        Eventually.holds(
            () -> {
              call.run();
              return leaseEnd(there) > leaseEnd + 10;
            });
      }
    }
  }

  /** Returns when the lease of the only session ends if nobody calls any more. */
  private static long leaseEnd(HostedClient there) {
    return there.host.listSimulations()[0].leaseEndsAt;
  }

  @Test
  void sessionNobodyRenewsDoesNotExistAnyMore() throws Exception {
    try (HostedClient there = new HostedClient(PacedSolver.endless(), BRIEF, 2)) {
      MechSim session = there.emptySession();
      Eventually.holds(() -> there.host.getLoad().sessions == 0);
      assertThatThrownBy(session::renewLease).isInstanceOf(OBJECT_NOT_EXIST.class);
    }
  }

  /** A thread that Java keeps for a while; its name has the process for which it waits. */
  private static final String REAPER = "process reaper";

  private static boolean isOfJava(Thread thread) {
    return thread.getName().equals("Common-Cleaner") || thread.getName().startsWith(REAPER);
  }

  @Test
  void nothingIsLeftOfAClosedHost() throws Exception {
    Set<Thread> before = Thread.getAllStackTraces().keySet();
    try (HostedClient there = HostedClient.with(new PacedSolver(100_000, 0))) {
      for (int i = 0; i < 3; i++) {
        IMechSimRemote run = there.simulation();
        run.start();
        run.openResults(ALL).nextBlock(0, 1000, new ResultBlockHolder());
      }
    }
    for (Thread thread : Thread.getAllStackTraces().keySet()) {
      if (!before.contains(thread) && !isOfJava(thread)) {
        thread.join(10_000);
        assertThat(thread.isAlive()).as(thread.getName()).isFalse();
      }
    }
    Eventually.holds(
        () ->
            Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> !before.contains(thread))
                .noneMatch(thread -> thread.getName().startsWith(REAPER + " (pid")));
    // Another process may just be making one of its own, which has its name for a moment only.
    Eventually.holds(() -> rowFiles() == 0);
  }

  private static long rowFiles() throws IOException {
    try (Stream<Path> all = Files.list(Path.of(System.getProperty("java.io.tmpdir")))) {
      return all.filter(file -> file.toString().endsWith(".rows")).count();
    }
  }

  @Test
  void slowReaderCostsTheHostNoMemory() throws UserException {
    int rows = 300_000; // 26 MB
    try (HostedClient there = HostedClient.with(new PacedSolver(rows, 0))) {
      IMechSimRemote run = there.simulation();
      ResultCursor slow = run.openResults(ALL);
      run.start();
      slow.nextBlock(1, 1000, new ResultBlockHolder());
      long before = usedHeap();
      ResultCursor other = run.openResults(new String[] {"t"});
      assertThat(CursorRows.toEnd(other, 0)).hasSize(rows);
      // The other client's own list of rows is the larger part of this.
      assertThat(usedHeap() - before).isLessThan(20_000_000);
      ResultBlockHolder block = new ResultBlockHolder();
      slow.nextBlock(1, 0, block);
      assertThat(block.value.values[0]).isEqualTo(1);
    }
  }

  private static long usedHeap() {
    System.gc();
    return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
  }
}
