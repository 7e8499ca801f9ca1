package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.FutureTask;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.guard.Confinement;
import org.mechservice.guard.UserCodePolicy;
import org.mechservice.idl.IMechSimRemote;
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
import org.omg.CORBA.OBJECT_NOT_EXIST;

/**
 * The wall of the operating system holds alone: with the allow-list of bytecode switched off,
 * classes that use all of Java reach nothing outside their process.
 */
@Tag("slow")
class ConfinedUserCodeTest {
  private static final String PUSH = "loads.addJointForce(slide, 3);";

  private static final NameValue[] FORCES = {new NameValue("columns", "joints,forces")};

  /** Velocity of the cart at the end of the run, m/s. */
  private static final double INSIDE = 1.5;

  private static Optional<Path> kept = Optional.empty();
  private static Optional<ServerSocket> listening = Optional.empty();

  @BeforeAll
  static void switchFirstWallOff() throws Exception {
    assumeTrue(
        Confinement.ofThisMachine().stands(),
        () -> "no confinement on this machine: " + Confinement.ofThisMachine().text());
    UserCodeAdmission.verifies = false;
    kept = Optional.of(Files.writeString(Files.createTempFile("host", ".txt"), "secret"));
    listening = Optional.of(new ServerSocket(0, 50, InetAddress.getLoopbackAddress()));
  }

  @AfterAll
  static void switchFirstWallOn() throws Exception {
    UserCodeAdmission.verifies = true;
    if (kept.isPresent()) {
      Files.deleteIfExists(kept.get());
    }
    if (listening.isPresent()) {
      listening.get().close();
    }
  }

  private static String pushing(String body) {
    return PushedCart.harmlessSource().replace(PUSH, body);
  }

  private static HostedClient host(HostLimits limits) {
    HostOptions options =
        new HostOptions("here", 2, limits, Optional.empty(), UserCodePolicy.CONFINED);
    return new HostedClient(SimHost.installedSolver(), options);
  }

  private static IMechSimRemote started(HostedClient there, String text) throws Exception {
    ModelFile force = new ModelFile("car/Push.java", text.getBytes(StandardCharsets.UTF_8));
    MechSim session = there.emptySession();
    session.loadModel(new ModelFile("pushed.xml", PushedCart.file()), new ModelFile[] {force});
    IMechSimRemote run = session.createSimulation(new NameValue[0], null);
    run.start();
    return run;
  }

  /** Returns the body of a force that throws what it could do outside. */
  private static String trying(String attempt) {
    return " { boolean out = false; try { "
        + attempt
        + " out = true; } catch (Exception e) { }"
        + " if (out) { throw new IllegalStateException(\"it got out\"); } }";
  }

  @Test
  void forceThatTriesToGetOutGoesOnInside() throws Exception {
    int port = listening.orElseThrow().getLocalPort();
    String reads =
        "java.nio.file.Files.readAllBytes(java.nio.file.Path.of(\"" + kept.orElseThrow() + "\"));";
    String connects = "new java.net.Socket(\"127.0.0.1\", " + port + ").close();";
    String starts = "Runtime.getRuntime().exec(\"/bin/sh\");";
    String body = trying(reads) + trying(connects) + trying(starts) + PUSH;
    try (HostedClient there = host(HostLimits.DEFAULT)) {
      IMechSimRemote run = started(there, pushing(body));
      List<double[]> rows = CursorRows.toEnd(run.openResults(HostedClient.ALL), 0);
      assertThat(run.getProgress().state).as(run.report()).isEqualTo(SimState.SIM_DONE);
      assertThat(rows.get(rows.size() - 1)[2]).isCloseTo(INSIDE, within(1e-8));
    }
  }

  @CsvSource(
      delimiter = '|',
      value = {
        "ends its process | System.exit(0); | S-157 | status 0",
        "ends its process at once | Runtime.getRuntime().halt(5); | S-157 | status 5",
        "writes among the messages | try (var out = new"
            + " java.io.FileOutputStream(java.io.FileDescriptor.out)) { out.write(new byte[100]); }"
            + " catch (Exception e) { } while (slide < 1000) { slide = slide % 7; } | S-157 | makes"
            + " no sense",
        "closes its output | try { new"
            + " java.io.FileOutputStream(java.io.FileDescriptor.out).close(); } catch (Exception e)"
            + " { } | S-157 | status",
        "throws an error | if (true) { throw new Error(\"boom\"); } | N-033 | java.lang.Error:"
            + " boom",
        "throws a long message | if (true) { throw new Error(\"b\".repeat(1000000)); } | N-033 |"
            + " java.lang.Error: bbb",
        "takes all memory | java.util.List<Object> all = new java.util.ArrayList<>(); while (true)"
            + " { try { all.add(new double[1000000]); } catch (Throwable e) { } } | S-110 | 100 MB",
        "never ends | while (slide < 1000) { slide = slide % 7; } | S-109 | processor time"
      })
  @ParameterizedTest(name = "{0}")
  void runOfAClassThatBreaksItsProcessFailsWithACode(
      String name, String body, String code, String text) throws Exception {
    HostLimits limits =
        HostLimits.DEFAULT.with(HostLimit.CPU_TIME, 3).with(HostLimit.WORKER_MEMORY, 100_000_000);
    try (HostedClient there = host(limits)) {
      IMechSimRemote run = started(there, pushing(body));
      Eventually.holds(() -> run.getProgress().state == SimState.SIM_FAILED);
      assertThat(run.failure().code).as(name).isEqualTo(code);
      assertThat(run.failure().text).contains(text).hasSizeLessThan(5000);
    }
  }

  /** The columns of a force's values are known when its first row is computed. */
  @Test
  void firstRowThatDoesNotEndEndsWithItsClient() throws Exception {
    try (HostedClient there = host(HostLimits.DEFAULT)) {
      MechSim session = there.emptySession();
      String text = pushing("while (slide < 1000) { slide = slide % 7; }");
      ModelFile force = new ModelFile("car/Push.java", text.getBytes(StandardCharsets.UTF_8));
      session.loadModel(new ModelFile("pushed.xml", PushedCart.file()), new ModelFile[] {force});
      FutureTask<Throwable> client =
          new FutureTask<>(() -> catchThrowable(() -> session.createSimulation(FORCES, null)));
      new Thread(client).start();
      Eventually.holds(() -> workers() == 1);
      session.destroy();
      Eventually.holds(() -> workers() == 0);
      assertThat(client.get()).as("no incident of the host").isInstanceOf(OBJECT_NOT_EXIST.class);
    }
  }

  /**
   * The host asks for its columns before there is a run; the reason is in the report of the run.
   */
  @Test
  void classThatEndsItsProcessInTheFirstRowFailsItsRun() throws Exception {
    try (HostedClient there = host(HostLimits.DEFAULT)) {
      MechSim session = there.emptySession();
      String text = pushing("System.exit(7);");
      ModelFile force = new ModelFile("car/Push.java", text.getBytes(StandardCharsets.UTF_8));
      session.loadModel(new ModelFile("pushed.xml", PushedCart.file()), new ModelFile[] {force});
      IMechSimRemote run = session.createSimulation(FORCES, null);
      run.start();
      Eventually.holds(() -> run.getProgress().state == SimState.SIM_FAILED);
      assertThat(run.failure().code).isEqualTo("S-157");
      assertThat(run.failure().text).contains("with status 7");
    }
  }

  /** Returns how many processes compute, each for a second at least. */
  private static long workers() {
    return ProcessHandle.current()
        .descendants()
        .filter(process -> process.info().commandLine().orElse("").contains("WorkerMain"))
        .filter(
            process -> process.info().totalCpuDuration().orElse(Duration.ZERO).toMillis() > 1000)
        .count();
  }

  /** Threads are bounded by the address space; other runs of the host go on. */
  @Test
  void threadsWithoutEndHarmNoOtherRun() throws Exception {
    String bomb =
        "for (int i = 0; i < 100000; i++) { Thread t = new Thread(() -> { try {"
            + " Thread.sleep(1000000); } catch (InterruptedException e) { } }); t.setDaemon(true);"
            + " t.start(); } ";
    HostLimits limits = HostLimits.DEFAULT.with(HostLimit.CPU_TIME, 10);
    try (HostedClient there = host(limits)) {
      IMechSimRemote hostile = started(there, pushing(bomb + PUSH));
      IMechSimRemote good = started(there, pushing(PUSH));
      List<double[]> rows = CursorRows.toEnd(good.openResults(HostedClient.ALL), 0);
      assertThat(rows.get(rows.size() - 1)[2]).isCloseTo(INSIDE, within(1e-8));
      Eventually.holds(() -> hostile.getProgress().state == SimState.SIM_FAILED);
    }
  }
}
