package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.SimState;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.host.SimHost;
import org.mechservice.sim.service.library.ClassLibrary;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.setup.SetUpWorkers;
import org.mechservice.solver.api.Solver;

/** A host that makes itself ready does what clients do, and nobody can tell afterwards. */
@Tag("slow")
class WarmUpTest {
  @TempDir private Path folder;

  @Test
  void runThatWarmsAHostUpIsCancelledInMidCourse() throws Exception {
    Solver solver = SimHost.installedSolver();
    try (HostedClient there = HostedClient.with(solver);
        SetUpWorkers setUps =
            new SetUpWorkers(new CurrentLimits(HostLimits.DEFAULT), new ClassLibrary());
        WarmUp warmUp = new WarmUp(there.hostOrb, solver, setUps)) {
      assertThat(warmUp.run()).isEqualTo(SimState.SIM_CANCELLED);
    }
  }

  private static final Set<String> OF_THE_MACHINE = Set.of("freeDisk", "processLoad");

  @Test
  void warmUpLeavesNoTrace() throws Exception {
    Solver solver = SimHost.installedSolver();
    HostOptions options = new HostOptions("here", 1, HostLimits.DEFAULT, Optional.of(folder));
    try (HostedClient there = new HostedClient(solver, options);
        SetUpWorkers setUps =
            new SetUpWorkers(new CurrentLimits(HostLimits.DEFAULT), new ClassLibrary());
        WarmUp warmUp = new WarmUp(there.hostOrb, solver, setUps)) {
      String before = traces(there);
      warmUp.run();
      assertThat(traces(there)).isEqualTo(before);
    }
  }

  /** All that clients, operators and a disk know of a host; not how busy its machine is. */
  private String traces(HostedClient there) throws Exception {
    HostLoad load = there.host.getLoad();
    StringBuilder traces = new StringBuilder();
    traces.append(load.sessions).append(' ').append(load.running).append(' ').append(load.queued);
    for (var count : load.statistics) {
      if (OF_THE_MACHINE.contains(count.key)) {
        continue;
      }
      traces.append(' ').append(count.key).append('=').append(count.text);
    }
    traces.append(' ').append(there.host.listSimulations().length).append(" runs, ");
    traces.append(there.host.logs(0, Integer.MAX_VALUE).length).append(" lines, ");
    traces.append(there.host.events(0, Integer.MAX_VALUE, 0).length).append(" events, ");
    try (Stream<Path> files = Files.list(folder)) {
      traces.append(files.map(file -> file.getFileName().toString()).sorted().toList());
    }
    return traces.toString();
  }

  @Test
  void modelBuiltWhileTheOrbStartsHasNoWarnings() throws Exception {
    assertThat(WarmUp.build()).isZero();
  }
}
