package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.Arrays;
import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.IMechSimRemote;
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
  private static final int RUNS = 60;
  private static final long SEED = 20031014;

  /** What the service promises. */
  private static final double LONGEST_SECONDS = 0.1;

  @Test
  void longRunsEndSoonAfterTheyAreCancelled() throws Exception {
    StringBuilder rows = new StringBuilder();
    try (MechServerProcess server =
            MechServerProcess.start(new ServerSettings("cancel", "127.0.0.1", 0, 1));
        ServiceOrb client = ServiceOrb.client()) {
      MechSim session = client.connect(server.url()).createSession("soak", "", null);
      String[][] cases = {
        {"pendulum/pendulum.xml", "ode113"},
        {"extremes/fourbar_redundant.xml", "ode15s"},
        {"extremes/fourbar_redundant.xml", "ode15sR"},
        {"pendulum/pendulum.xml", "ode15s"}
      };
      for (String[] one : cases) {
        double[] seconds = measured(session, one[0], one[1]);
        double median = seconds[seconds.length / 2];
        rows.append(
            String.format(
                Locale.ROOT,
                "| %s | %s | %d | %.1f ms | %.1f ms |%n",
                one[0],
                one[1],
                seconds.length,
                1e3 * median,
                1e3 * seconds[seconds.length - 1]));
        assertThat(median).as("%s, %s", one[0], one[1]).isLessThan(LONGEST_SECONDS);
      }
    }
    Files.writeString(
        Path.of("../docs/reports/service-cancel.md"),
        String.format(
            Locale.ROOT,
            """
            # How soon a cancelled run has ended

            Measured on %s by `mvn verify -Psoak`: JDK %s, %d processors, load average %.1f, loopback. Long runs are cancelled at random moments (seed %d), which in stiff ones are mostly inside Newton iterations and Jacobians. The time is counted from the client's call of `cancel` to the first `getProgress` that says cancelled. That a run makes no evaluation after the one in which it was cancelled is a test of its own, which counts them.

            | model | integrator | runs | median | longest |
            |---|---|---|---|---|
            %s""",
            LocalDate.now(ZoneOffset.UTC),
            Runtime.version(),
            Runtime.getRuntime().availableProcessors(),
            ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
            SEED,
            rows));
  }

  /** Returns the times of all runs in ascending order, s. */
  private static double[] measured(MechSim session, String model, String integrator)
      throws Exception {
    Path file = Path.of("../examples", model);
    session.loadModel(
        new ModelFile(file.getFileName().toString(), Files.readAllBytes(file)), new ModelFile[0]);
    Random random = new Random(SEED);
    double[] seconds = new double[RUNS];
    for (int i = 0; i < RUNS; i++) {
      seconds[i] = cancelled(session, integrator, random.nextInt(100));
    }
    Arrays.sort(seconds);
    return seconds;
  }

  private static double cancelled(MechSim session, String integrator, int afterMillis)
      throws UserException, InterruptedException {
    NameValue[] options = {
      new NameValue(OPT_INTEGRATOR.value, integrator),
      new NameValue(OPT_REL_TOL.value, "1e-10"),
      new NameValue(OPT_T_END.value, "1e6"),
      new NameValue(OPT_T_STEP.value, "1e3")
    };
    IMechSimRemote run = session.createSimulation(options, null);
    run.start();
    while (run.getProgress().stepsDone == 0) {
      Thread.sleep(1);
    }
    Thread.sleep(afterMillis);
    long asked = System.nanoTime();
    run.cancel();
    SimState state = run.getProgress().state;
    while (state == SimState.SIM_RUNNING) {
      state = run.getProgress().state;
    }
    double seconds = (System.nanoTime() - asked) * 1e-9;
    assertThat(state).isEqualTo(SimState.SIM_CANCELLED);
    run.destroy();
    return seconds;
  }
}
