package org.mechservice.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.ServiceConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.ModelMessage;

/** What is said before a run is said of the run asked for, wherever it will be. */
class ForecastTest {
  /** A stiff hinge whose file asks for ode15sR. */
  private static final Path STIFF = Path.of("../examples/extremes/stiff_1e9_c1e5.xml");

  @Test
  void runIsForecastAsItWillBeRemoteAndLocalInTheSameWords() throws IOException {
    SimulationOptions asInFile = SimulationOptions.asInFile();
    SimulationOptions explicit = asInFile.integrator("ode113").endTime(100);
    try (ServiceConnection service = ServiceConnection.open(new ServerOption());
        MechSession session = service.connection().openSession("")) {
      assertThat(session.loadModel(STIFF)).isEmpty();
      session.prepareRemoteRun(explicit).close();
      List<ModelMessage> remote = session.warnings();
      session.prepareLocalRun(asInFile).close();
      assertThat(session.warnings()).isEmpty();
      session.prepareLocalRun(explicit).close();
      assertThat(session.warnings()).isEqualTo(remote).hasSize(1);
    }
  }

  @Test
  void forecastNamesTheJointTheIntegratorAndTheEndOfTheRun() throws IOException {
    try (ServiceConnection service = ServiceConnection.open(new ServerOption());
        MechSession session = service.connection().openSession("")) {
      session.loadModel(STIFF);
      session
          .prepareRemoteRun(SimulationOptions.asInFile().integrator("ode113").endTime(100))
          .close();
      assertThat(session.warnings().get(0).toString())
          .startsWith(STIFF + ":26: N-019 joint \"j1\" moves too fast for ode113")
          .contains("to 100 s, its end");
    }
  }

  @Test
  void silencedForecastIsNotGivenRemoteAndLocal() throws IOException {
    SimulationOptions silent =
        SimulationOptions.asInFile().integrator("ode113").endTime(100).silence("very-many-steps");
    try (ServiceConnection service = ServiceConnection.open(new ServerOption());
        MechSession session = service.connection().openSession("")) {
      session.loadModel(STIFF);
      session.prepareRemoteRun(silent).close();
      assertThat(session.warnings()).isEmpty();
      session.prepareLocalRun(silent).close();
      assertThat(session.warnings()).isEmpty();
    }
  }
}
