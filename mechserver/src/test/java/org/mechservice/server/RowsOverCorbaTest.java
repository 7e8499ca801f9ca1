package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.SimState;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.testing.CursorRows;
import org.mechservice.sim.host.HostSettings;
import org.mechservice.sim.host.SimHostProcess;
import org.omg.CORBA.UserException;

@Tag("slow")
class RowsOverCorbaTest {
  private static final String[] ALL = new String[0];
  private static final NameValue[] AS_IN_FILE = new NameValue[0];

  @Test
  void rowsAreTheSameStepByStepInBlocksAndAtTheEnd() throws UserException {
    try (MechServerProcess server =
            MechServerProcess.start(new ServerSettings("s", "127.0.0.1", 0, 2));
        ServiceOrb orb = ServiceOrb.client()) {
      MechServer service = orb.connect(server.url());
      MechSim session = service.createSession("test", "", null);
      session.loadModel(Pendulum.file(), new ModelFile[0]);
      IMechSimRemote run = session.createSimulation(AS_IN_FILE, null);
      run.start();
      List<double[]> oneByOne = CursorRows.toEnd(run.openResults(ALL), 1);
      List<double[]> inBlocks = CursorRows.toEnd(run.openResults(ALL), 7);
      List<double[]> atTheEnd = CursorRows.toEnd(run.openResults(ALL), 0);
      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_DONE);
      assertThat(oneByOne).hasSize(Pendulum.ROWS);
      assertThat(oneByOne.get(0)).hasSize(Pendulum.COLUMNS);
      assertThat(inBlocks).usingElementComparator(Arrays::compare).isEqualTo(oneByOne);
      assertThat(atTheEnd).usingElementComparator(Arrays::compare).isEqualTo(oneByOne);
    }
  }

  @Test
  void registeredHostRunsTheSessionAndGivesTheSameRows() throws UserException {
    try (MechServerProcess server =
            MechServerProcess.start(new ServerSettings("s", "127.0.0.1", 0, 2));
        SimHostProcess host =
            SimHostProcess.start(new HostSettings(server.url(), "h", "127.0.0.1", 0, 2));
        ServiceOrb orb = ServiceOrb.client()) {
      MechServer service = orb.connect(server.url());
      MechSim here = service.createSession("test", "s", null);
      MechSim there = service.createSession("test", "", null);
      assertThat(there.hostName()).isEqualTo("h");
      assertThat(orb.endpointOf(there).toString()).isEqualTo(host.address());
      assertThat(run(there)).usingElementComparator(Arrays::compare).isEqualTo(run(here));
    }
  }

  @Test
  void hostCallsTheClientBackThatTheServerSentToIt() throws Exception {
    RecordedCallbacks callbacks = new RecordedCallbacks();
    try (MechServerProcess server =
            MechServerProcess.start(new ServerSettings("s", "127.0.0.1", 0, 2));
        SimHostProcess host =
            SimHostProcess.start(new HostSettings(server.url(), "h", "127.0.0.1", 0, 2));
        ServiceOrb orb = ServiceOrb.client()) {
      MechSim session =
          orb.connect(server.url()).createSession("test", "h", orb.export(callbacks.client()));
      assertThat(orb.endpointOf(session).toString()).isEqualTo(host.address());
      assertThat(run(session)).hasSize(Pendulum.ROWS);
      callbacks.awaitDone();
    }
  }

  private static List<double[]> run(MechSim session) throws UserException {
    session.loadModel(Pendulum.file(), new ModelFile[0]);
    IMechSimRemote run = session.createSimulation(AS_IN_FILE, null);
    run.start();
    return CursorRows.toEnd(run.openResults(ALL), 0);
  }
}
