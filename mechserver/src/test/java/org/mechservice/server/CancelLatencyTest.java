package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.OPT_INTEGRATOR;
import org.mechservice.idl.OPT_REL_TOL;
import org.mechservice.idl.OPT_T_END;
import org.mechservice.idl.OPT_T_STEP;
import org.mechservice.idl.SimState;
import org.mechservice.orb.ServiceOrb;
import org.omg.CORBA.UserException;

/**
 * Cancels long runs at random moments and writes how soon they had ended to
 * docs/reports/service-cancel.md.
 */
@Tag("soak")
class CancelLatencyTest {
  private static final long SEED = 20031014;

  /** What a service promises that is ready. */
  private static final double LONGEST_SECONDS = 0.1;

  /** A server uses what its clients will need once itself; by then it has. */
  private static final int READY_MILLIS = 5000;

  /** Of a server that has only just begun with that; nothing is promised. */
  private static final Case AT_ONCE = new Case("pendulum/pendulum.xml", "ode113", 3, 100);

  /** The third factors matrices of 2000 unknowns, which takes seconds. */
  private static final List<Case> CASES =
      List.of(
          new Case("pendulum/pendulum.xml", "ode113", 60, 100),
          new Case("extremes/fourbar_redundant.xml", "ode15s", 60, 100),
          new Case("extremes/fourbar_redundant.xml", "ode15sR", 60, 100),
          new Case("pendulum/pendulum.xml", "ode15s", 60, 100),
          new Case("extremes/chain_1000.xml", "ode15s", 15, 4000));

  /**
   * Runs to be cancelled.
   *
   * @param model below examples
   * @param runs how many
   * @param latest most milliseconds from the start of a run to its cancel
   */
  private record Case(String model, String integrator, int runs, int latest) {
    NameValue[] options() {
      return new NameValue[] {
        new NameValue(OPT_INTEGRATOR.value, integrator),
        new NameValue(OPT_REL_TOL.value, "1e-10"),
        new NameValue(OPT_T_END.value, "1e8"),
        new NameValue(OPT_T_STEP.value, "1e5")
      };
    }
  }

  @Test
  void runsEndSoonAfterTheyAreCancelled() throws Exception {
    StringBuilder rows = new StringBuilder();
    double longest = 0;
    double[] atOnce;
    try (MechServerProcess server =
            MechServerProcess.start(new ServerSettings("cancel", "127.0.0.1", 0, 2));
        ServiceOrb client = ServiceOrb.client()) {
      server.warmUp(); // as the command does; nobody waits for it
      MechServer service = client.connect(server.url());
      IMechSimRemote beside = simulation(service.createSession("beside", "", null), CASES.get(0));
      beside.start();
      atOnce = measured(service, beside, AT_ONCE, CancelLatencyTest::cancel);
      Thread.sleep(READY_MILLIS);
      for (Case one : CASES) {
        double[] cancels = measured(service, beside, one, CancelLatencyTest::cancel);
        double[] destroys = measured(service, beside, one, IMechSimRemote::destroy);
        longest = Math.max(longest, Math.max(last(cancels), last(destroys)));
        rows.append(
            String.format(
                Locale.ROOT,
                "| %s | %s | %d | %.1f ms | %.1f ms | %.1f ms | %.1f ms |%n",
                one.model(),
                one.integrator(),
                one.runs(),
                1e3 * cancels[cancels.length / 2],
                1e3 * last(cancels),
                1e3 * destroys[destroys.length / 2],
                1e3 * last(destroys)));
      }
      beside.destroy();
    }
    Files.writeString(
        Path.of("../docs/reports/service-cancel.md"),
        String.format(
            Locale.ROOT,
            """
            # How soon a cancelled run has ended

            Measured on %s by `mvn verify -Psoak`: JDK %s, %d processors, load average %.1f, loopback. Long runs are cancelled at random moments (seed %d), which in stiff ones are mostly inside Newton iterations and Jacobians, in the chain of 1000 bars inside differences and factorisations of matrices of 2000 unknowns; another run goes on beside them all the time. The time is counted from the client's call of `cancel` to the answer of a `getProgress` that says cancelled; of as many other runs, from the call of `destroy` to its answer. A solver that is deep in one evaluation or factorisation is waited for 30 ms, then its run has ended without it; with a spool folder, the disk is waited for 20 ms more. That a run makes no evaluation after the one in which it was cancelled is a test of its own, which counts them.

            | model | integrator | runs of each kind | cancel, median | longest | destroy, median | longest |
            |---|---|---|---|---|---|---|
            %s
            All this is of a server that has warmed up, as `mech server` and `mech simhost` do when they have started: it has loaded, run and cancelled a small model of its own, so that the first cancel of a client waits for no classes to be loaded (a test of its own). Of %d runs begun and cancelled in the moment the server started, beside its own, the longest took %.1f ms.
            """,
            LocalDate.now(ZoneOffset.UTC),
            Runtime.version(),
            Runtime.getRuntime().availableProcessors(),
            ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
            SEED,
            rows,
            AT_ONCE.runs(),
            1e3 * last(atOnce)));
    assertThat(longest).isLessThan(LONGEST_SECONDS);
  }

  /**
   * Returns the times of all runs in ascending order, s.
   *
   * @param beside goes on all the time
   */
  private static double[] measured(
      MechServer service, IMechSimRemote beside, Case one, Ending ending) throws Exception {
    MechSim session = service.createSession("soak", "", null);
    Random random = new Random(SEED);
    double[] seconds = new double[one.runs()];
    for (int i = 0; i < seconds.length; i++) {
      seconds[i] = ended(simulation(session, one), random.nextInt(one.latest()), ending);
      assertThat(beside.getProgress().state).isEqualTo(SimState.SIM_RUNNING);
    }
    session.destroy();
    Arrays.sort(seconds);
    return seconds;
  }

  private static IMechSimRemote simulation(MechSim session, Case one) throws Exception {
    Path file = Path.of("../examples", one.model());
    session.loadModel(
        new ModelFile(file.getFileName().toString(), Files.readAllBytes(file)), new ModelFile[0]);
    return session.createSimulation(one.options(), null);
  }

  /** What ends a run. */
  private interface Ending {
    void end(IMechSimRemote run) throws UserException;
  }

  private static void cancel(IMechSimRemote run) {
    run.cancel();
    assertThat(run.getProgress().state).isEqualTo(SimState.SIM_CANCELLED);
  }

  private static double ended(IMechSimRemote run, int afterMillis, Ending ending)
      throws UserException, InterruptedException {
    run.start();
    while (run.getProgress().state != SimState.SIM_RUNNING) {
      Thread.sleep(1);
    }
    Thread.sleep(afterMillis);
    long asked = System.nanoTime();
    ending.end(run);
    return (System.nanoTime() - asked) * 1e-9;
  }

  private static double last(double[] ascending) {
    return ascending[ascending.length - 1];
  }
}
