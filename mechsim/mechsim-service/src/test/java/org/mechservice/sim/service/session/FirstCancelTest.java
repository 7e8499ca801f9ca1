package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.LongSupplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.MechSimHelper;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.OPT_T_END;
import org.mechservice.idl.OPT_T_STEP;
import org.mechservice.idl.SimState;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.testing.Eventually;

/**
 * Who cancels first in the life of a host waits no longer than those after him: what Java would
 * have to load, link and spin for it has been used before. The host tells, in a process of its own,
 * which classes it loads, and when.
 */
@Tag("slow")
class FirstCancelTest {
  private static final NameValue[] LONG_RUN = {
    new NameValue(OPT_T_END.value, "1e6"), new NameValue(OPT_T_STEP.value, "1e3")
  };

  /** So long nothing may be loaded before the run is said to be under way. */
  private static final int QUIET_LOOKS = 10;

  private static final int LOOK_MILLIS = 50;

  @TempDir private Path folder;

  @Test
  void firstCancelOfAHostThatIsReadyLoadsNoClass() throws Exception {
    Path loaded = folder.resolve("loaded");
    Process host = startHost(loaded);
    try (BufferedReader out = host.inputReader();
        ServiceOrb orb = ServiceOrb.client()) {
      MechSim session = MechSimHelper.unchecked_narrow(orb.fromIor(out.readLine()));
      session.loadModel(HostedClient.pendulum(), new ModelFile[0]);
      IMechSimRemote run = session.createSimulation(LONG_RUN, null);
      run.start();
      Eventually.holds(() -> run.getProgress().stepsDone > 0);
      int before = linesWhenQuiet(loaded, () -> run.getProgress().stepsDone);
      run.cancel();
      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_CANCELLED);
      linesWhenQuiet(loaded, System::nanoTime);
      assertThat(Files.readAllLines(loaded).stream().skip(before).filter(FirstCancelTest::isOurs))
          .isEmpty();
    } finally {
      host.destroyForcibly().waitFor();
    }
  }

  /** Java loads some of its own whenever two of its threads happen to meet. */
  private static boolean isOurs(String line) {
    return line.startsWith("org.");
  }

  private static Process startHost(Path loaded) throws IOException {
    return new ProcessBuilder(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-Xlog:class+load:file=" + loaded + ":none:filecount=0",
            "-cp",
            System.getProperty("java.class.path"),
            WarmHostMain.class.getName())
        .redirectError(ProcessBuilder.Redirect.DISCARD)
        .start();
  }

  /**
   * Returns how many classes have been loaded when no more are.
   *
   * @param clock grows while the host does what it is watched for: a host that gets no processor
   *     time loads nothing, either
   */
  private static int linesWhenQuiet(Path loaded, LongSupplier clock) throws Exception {
    long size = -1;
    long time = clock.getAsLong();
    int quiet = 0;
    while (quiet < QUIET_LOOKS) {
      long now = Files.size(loaded);
      long later = clock.getAsLong();
      if (now != size) {
        quiet = 0;
      } else if (later > time) {
        quiet++;
      }
      size = now;
      time = later;
      Thread.sleep(LOOK_MILLIS);
    }
    return Files.readAllLines(loaded).size();
  }
}
