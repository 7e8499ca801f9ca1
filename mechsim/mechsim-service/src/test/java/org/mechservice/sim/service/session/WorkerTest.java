package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.guard.Confinement;
import org.mechservice.guard.UserCodePolicy;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.SimState;
import org.mechservice.orb.testing.CursorRows;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.host.SimHost;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.user.PushedCart;
import org.omg.CORBA.UserException;

/** Forces that users have written run in processes of their own, and can do no harm there. */
@Tag("slow")
class WorkerTest {
  private static final ModelFile MODEL = new ModelFile("pushed.xml", PushedCart.file());

  /** Where the class of the force pushes. */
  private static final String PUSH = "loads.addJointForce(slide, 3);";

  private static final String LOOP = "while (slide < 10) { slide = slide % 3; }";

  /** A tenth of a second. */
  private static final String SLOW =
      "double x = 1; for (int i = 0; i < 20000000; i++) { x = x / 3 + 1; }"
          + " if (x > 2) { throw new IllegalStateException(); }";

  private static final String BOMB =
      """
      java.util.List<double[]> kept = new java.util.ArrayList<>();
      while (slide < 10) {
        try {
          kept.add(new double[1000000]);
        } catch (RuntimeException e) {
          slide = 0;
        }
      }
      """;

  private static HostedClient host(HostLimits limits) {
    return new HostedClient(
        SimHost.installedSolver(),
        new HostOptions("here", 3, limits, Optional.empty(), UserCodePolicy.UNCONFINED));
  }

  private static IMechSimRemote simulation(HostedClient there, String body) throws UserException {
    MechSim session = there.emptySession();
    String text = PushedCart.harmlessSource().replace(PUSH, body);
    ModelFile force = new ModelFile("car/Push.java", text.getBytes(StandardCharsets.UTF_8));
    session.loadModel(MODEL, new ModelFile[] {force});
    return session.createSimulation(new NameValue[0], null);
  }

  /** The processes of runs, also within the wall; a host has its compiler in a process, too. */
  private static Stream<ProcessHandle> workers() {
    return ProcessHandle.current().children().filter(WorkerTest::isWorker);
  }

  private static boolean isWorker(ProcessHandle child) {
    // the handle knows no arguments of a command as long as this
    Path words = Path.of("/proc", Long.toString(child.pid()), "cmdline");
    try {
      String line =
          Files.isReadable(words) ? Files.readString(words) : child.info().commandLine().orElse("");
      return line.contains("org.mechservice.guard.worker");
    } catch (IOException e) {
      // it has ended
      return false;
    }
  }

  /** Returns whether Java runs in a process of a run: behind its wall, if there is one. */
  private static boolean isComplete(ProcessHandle worker) {
    return !Confinement.ofThisMachine().stands() || worker.descendants().count() >= 2;
  }

  private static void assertFailsWith(IMechSimRemote run, String code) throws Exception {
    Eventually.holds(() -> run.getProgress().state == SimState.SIM_FAILED);
    assertThat(run.failure().code).isEqualTo(code);
    Eventually.holds(() -> workers().findAny().isEmpty());
  }

  @Test
  void endlessLoopIsStoppedByTheLimitOfProcessorTime() throws Exception {
    try (HostedClient there = host(HostLimits.DEFAULT.with(HostLimit.CPU_TIME, 2))) {
      IMechSimRemote run = simulation(there, LOOP);
      run.start();
      assertFailsWith(run, "S-109");
    }
  }

  @Test
  void allocationBombIsStoppedByTheLimitOfMemory() throws Exception {
    try (HostedClient there = host(HostLimits.DEFAULT.with(HostLimit.MEMORY, 256_000_000))) {
      IMechSimRemote run = simulation(there, BOMB);
      run.start();
      assertFailsWith(run, "S-110");
    }
  }

  @Test
  void loopAndBombHarmNoOtherRun() throws Exception {
    HostLimits limits =
        HostLimits.DEFAULT.with(HostLimit.CPU_TIME, 3).with(HostLimit.MEMORY, 256_000_000);
    try (HostedClient there = host(limits)) {
      IMechSimRemote alone = simulation(there, PUSH);
      alone.start();
      List<double[]> rows = CursorRows.toEnd(alone.openResults(HostedClient.ALL), 0);
      IMechSimRemote loop = simulation(there, LOOP);
      IMechSimRemote bomb = simulation(there, BOMB);
      loop.start();
      bomb.start();
      for (int i = 0; i < 3; i++) {
        IMechSimRemote good = simulation(there, PUSH);
        good.start();
        assertThat(CursorRows.toEnd(good.openResults(HostedClient.ALL), 0))
            .usingElementComparator(Arrays::compare)
            .isEqualTo(rows);
      }
      assertFailsWith(loop, "S-109");
      assertFailsWith(bomb, "S-110");
    }
  }

  @Test
  void killedWorkerHarmsNoOtherRun() throws Exception {
    // the worker of an earlier test may still be ending
    Eventually.holds(() -> workers().findAny().isEmpty());
    try (HostedClient there = host(HostLimits.DEFAULT)) {
      IMechSimRemote endless = simulation(there, LOOP);
      endless.start();
      // half of a wall that is killed while it is built stays, and holds the streams
      Eventually.holds(() -> workers().anyMatch(WorkerTest::isComplete));
      ProcessHandle first = workers().findAny().orElseThrow();
      IMechSimRemote good = simulation(there, PUSH);
      first.destroyForcibly();
      good.start();
      assertFailsWith(endless, "S-178");
      Eventually.holds(() -> good.getProgress().state == SimState.SIM_DONE);
    }
  }

  @Test
  void endlessLoopIsCancelled() throws Exception {
    try (HostedClient there = host(HostLimits.DEFAULT)) {
      IMechSimRemote run = simulation(there, LOOP);
      run.start();
      Eventually.holds(() -> workers().findAny().isPresent());
      run.cancel();
      Eventually.holds(() -> run.getProgress().state == SimState.SIM_CANCELLED);
      Eventually.holds(() -> workers().findAny().isEmpty());
    }
  }

  @Test
  void workerIsSteeredLikeARunOfTheHost() throws Exception {
    try (HostedClient there = host(HostLimits.DEFAULT)) {
      IMechSimRemote run = simulation(there, PUSH);
      for (int step = 1; step <= 3; step++) {
        long steps = step;
        run.stepOnce();
        Eventually.holds(
            () ->
                run.getProgress().state == SimState.SIM_PAUSED
                    && run.getProgress().stepsDone == steps);
      }
      run.resume();
      Eventually.holds(() -> run.getProgress().state == SimState.SIM_DONE);
      assertThat(run.report()).contains("\"outcome\":\"completed\"").contains("\"solverVersion\"");
    }
  }

  private static IMechSimRemote held(IMechSimRemote run) throws Exception {
    run.runTo(0.5);
    Eventually.holds(() -> run.getProgress().state == SimState.SIM_PAUSED);
    return run;
  }

  private static List<double[]> rowsToEnd(IMechSimRemote run) throws UserException {
    run.start();
    return CursorRows.toEnd(run.openResults(HostedClient.ALL), 0);
  }

  @Test
  void workerTakenUpFromAHeldOneHasTheSameRowsAsOneNeverInterrupted() throws Exception {
    try (HostedClient there = host(HostLimits.DEFAULT)) {
      List<double[]> whole = rowsToEnd(simulation(there, PUSH));
      byte[] checkpoint = held(simulation(there, PUSH)).checkpoint();
      IMechSimRemote resumed = simulation(there, PUSH);
      resumed.restore(checkpoint);
      List<double[]> rest = rowsToEnd(resumed);

      assertThat(resumed.getProgress().state).isEqualTo(SimState.SIM_DONE);
      assertThat(rest).hasSizeBetween(1, whole.size() - 1);
      assertThat(rest)
          .usingElementComparator(Arrays::compare)
          .isEqualTo(whole.subList(whole.size() - rest.size(), whole.size()));
    }
  }

  @Test
  void workerIsSavedWhileItGoesOn() throws Exception {
    try (HostedClient there = host(HostLimits.DEFAULT)) {
      // A spring: hundreds of steps, so that it still runs where news of the first ones comes late;
      // each of some milliseconds, so that one ends within a second on a busy machine too.
      String spring = "loads.addJointForce(slide, 3 - 1000 * slide);";
      String brief = SLOW.replace("20000000", "3000000");
      IMechSimRemote run = simulation(there, brief + spring);
      run.start();
      Eventually.holds(() -> run.getProgress().stepsDone > 2);
      assertThat(savedAfterAStep(run)).isNotEmpty();
      long saved = run.getProgress().stepsDone;
      Eventually.holds(() -> run.getProgress().stepsDone > saved);
      run.cancel();
    }
  }

  /**
   * Returns a checkpoint of a run that goes on. A call waits for the next step for a second, then
   * it is refused; on a busy machine a step of this force takes longer, so the call is repeated.
   */
  private static byte[] savedAfterAStep(IMechSimRemote run) throws Exception {
    List<byte[]> made = new ArrayList<>();
    Eventually.holds(
        () -> {
          try {
            return made.add(run.checkpoint());
          } catch (InvalidState takesNoStepNow) {
            assertThat(takesNoStepNow.current).isEqualTo(SimState.SIM_RUNNING);
            return false;
          }
        });
    return made.get(0);
  }

  @Test
  void cancelledWorkerHasLeftACheckpoint() throws Exception {
    try (HostedClient there = host(HostLimits.DEFAULT)) {
      IMechSimRemote run = held(simulation(there, PUSH));
      run.cancel();
      Eventually.holds(() -> run.getProgress().state == SimState.SIM_CANCELLED);
      assertThat(run.checkpoint()).isNotEmpty();
    }
  }

  @Test
  void checkpointOfAnotherForceIsRefused() throws Exception {
    try (HostedClient there = host(HostLimits.DEFAULT)) {
      IMechSimRemote held = held(simulation(there, PUSH));
      byte[] checkpoint = held.checkpoint();
      held.destroy();
      IMechSimRemote other = simulation(there, PUSH.replace("3", "4"));
      other.restore(checkpoint);
      other.start();
      assertFailsWith(other, "S-071");
    }
  }

  @CsvSource(
      delimiter = '|',
      value = {
        "System.exit(0);|java.lang.System.exit",
        "new java.io.File(\"x\").delete();|java.io.File",
        "try { new java.net.Socket(\"h\", 1); } catch (Exception e) { slide = 0; }|java.net.Socket",
        "new Thread(() -> {}).start();|java.lang.Thread",
        "try { Runtime.getRuntime().exec(\"x\"); } catch (Exception e) { slide = 0; }|Runtime",
        "try { Class.forName(\"x\"); } catch (Exception e) { slide = 0; }|java.lang.Class.forName",
        "getClass().getClassLoader();|Class.getClassLoader",
        "java.util.List.of(1).parallelStream().count();|parallelStream",
        "Runnable r = System::gc; r.run();|java.lang.System.gc"
      })
  @ParameterizedTest
  void whatReachesBeyondNumbersIsRefusedWithItsLine(String body, String named) throws Exception {
    try (HostedClient there = host(HostLimits.DEFAULT)) {
      InvalidModel refusal =
          catchThrowableOfType(InvalidModel.class, () -> simulation(there, body));
      assertThat(refusal.diagnostics).isNotEmpty();
      Diagnostic first = refusal.diagnostics[0];
      assertThat(first.code).isEqualTo("S-156");
      assertThat(Stream.of(refusal.diagnostics).map(said -> said.text))
          .anySatisfy(
              text ->
                  assertThat(text).contains("class car.Push, method apply, line ").contains(named));
    }
  }

  @Test
  void mathematicsTextsAndCollectionsAreAllowed() throws Exception {
    try (HostedClient there = host(HostLimits.DEFAULT)) {
      String body =
          """
          double[] a = {1, 2};
          double[] b = new double[2];
          System.arraycopy(a, 0, b, 0, 2);
          java.util.function.DoubleUnaryOperator f = x -> Math.sin(x) * b[0];
          java.util.Map<String, Double> m = new java.util.HashMap<>();
          m.put("x" + slide, f.applyAsDouble(0));
          switch ("a" + slide) { case "b": throw new IllegalStateException("b"); default: break; }
          record P(double x) {}
          loads.addJointForce(slide, 3 + m.get("x" + slide) + 0 * new P(1).hashCode());
          """;
      IMechSimRemote run = simulation(there, body);
      run.start();
      Eventually.holds(() -> run.getProgress().state == SimState.SIM_DONE);
    }
  }
}
