package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.testing.CursorRows;
import org.omg.CORBA.UserException;

/** Server and host in processes of their own, as in the field. */
@Tag("slow")
class SeparateProcessTest {
  private static Process startHost(String serverUrl, String name) throws IOException {
    return new ProcessBuilder(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-cp",
            System.getProperty("java.class.path"),
            HostMain.class.getName(),
            serverUrl,
            name)
        .redirectErrorStream(false)
        .redirectError(ProcessBuilder.Redirect.DISCARD)
        .start();
  }

  @Test
  void killedHostIsDroppedAndItsWorkIsDoneElsewhere() throws Exception {
    try (MechServerProcess server =
            MechServerProcess.start(
                new ServerSettings("own", "127.0.0.1", 0, 1), Farm.STEADY, HostFactory.INSTALLED);
        ServiceOrb orb = ServiceOrb.client()) {
      MechServer service = orb.connect(server.url());
      Process host = startHost(server.url(), "far");
      try (BufferedReader out = host.inputReader()) {
        assertThat(out.readLine()).startsWith("127.0.0.1:");
        MechSim far = service.createSession("test", "", null);
        assertThat(far.hostName()).isEqualTo("far");
        List<double[]> rowsFromFar = run(far);
        host.destroyForcibly().waitFor();
        MechSim own = service.createSession("test", "", null);
        assertThat(own.hostName()).isEqualTo("own");
        assertThat(run(own)).usingElementComparator(Arrays::compare).isEqualTo(rowsFromFar);
      } finally {
        host.destroyForcibly();
      }
    }
  }

  private static List<double[]> run(MechSim session) throws UserException {
    session.loadModel(Pendulum.file(), new ModelFile[0]);
    IMechSimRemote run = session.createSimulation(new NameValue[0], null);
    run.start();
    return CursorRows.toEnd(run.openResults(new String[0]), 0);
  }
}
