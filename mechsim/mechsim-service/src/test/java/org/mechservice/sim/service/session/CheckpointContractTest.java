package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.mechservice.sim.service.session.HostedClient.ALL;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.SimState;
import org.mechservice.orb.testing.CursorRows;
import org.omg.CORBA.UserException;

/** What clients are promised about checkpoints. */
@Tag("slow")
class CheckpointContractTest {
  private static final NameValue[] AS_IN_FILE = new NameValue[0];

  private static IMechSimRemote heldAt(MechSim session, double time) throws Exception {
    IMechSimRemote run = session.createSimulation(AS_IN_FILE, null);
    run.runTo(time);
    while (run.getProgress().state != SimState.SIM_PAUSED) {
      Thread.onSpinWait();
    }
    return run;
  }

  private static List<double[]> rowsToEnd(IMechSimRemote run) throws UserException {
    run.start();
    return CursorRows.toEnd(run.openResults(ALL), 0);
  }

  @Test
  void runTakenUpFromAHeldOneHasTheSameRowsAsOneNeverInterrupted() throws Exception {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      MechSim session = there.session();
      List<double[]> whole = rowsToEnd(session.createSimulation(AS_IN_FILE, null));
      byte[] checkpoint = heldAt(session, 1).checkpoint();
      IMechSimRemote resumed = session.createSimulation(AS_IN_FILE, null);
      resumed.restore(checkpoint);
      List<double[]> rest = rowsToEnd(resumed);

      assertThat(rest).hasSizeLessThan(whole.size()).isNotEmpty();
      assertThat(rest.get(0)[0]).isGreaterThan(1);
      int missing = whole.size() - rest.size();
      for (int row = 0; row < rest.size(); row++) {
        assertThat(rest.get(row)).isEqualTo(whole.get(missing + row));
      }
    }
  }

  @Test
  void cancelledRunHasLeftACheckpoint() throws Exception {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      MechSim session = there.session();
      IMechSimRemote run = heldAt(session, 1);
      run.cancel();
      while (run.getProgress().state != SimState.SIM_CANCELLED) {
        Thread.onSpinWait();
      }

      assertThat(run.checkpoint()).isNotEmpty();
    }
  }

  @Test
  void checkpointOfOtherSettingsIsRefusedByName() throws Exception {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      MechSim session = there.session();
      byte[] checkpoint = heldAt(session, 1).checkpoint();
      NameValue[] other = {new NameValue("rtol", "1e-9")};
      IMechSimRemote run = session.createSimulation(other, null);
      run.restore(checkpoint);
      rowsToEnd(run);

      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_FAILED);
      assertThat(run.failure().code).isEqualTo("S-071");
      assertThat(run.failure().text).contains("1.0E-9");
    }
  }

  @Test
  void damagedCheckpointIsRefused() throws Exception {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      MechSim session = there.session();
      byte[] checkpoint = heldAt(session, 1).checkpoint();
      checkpoint[checkpoint.length / 2] ^= 1;
      IMechSimRemote run = session.createSimulation(AS_IN_FILE, null);
      run.restore(checkpoint);
      rowsToEnd(run);

      assertThat(run.failure().code).isEqualTo("S-071");
    }
  }

  @Test
  void nothingIsSavedBeforeTheStartOrRestoredAfterIt() throws Exception {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      MechSim session = there.session();
      IMechSimRemote run = session.createSimulation(AS_IN_FILE, null);
      InvalidState early = catchThrowableOfType(InvalidState.class, run::checkpoint);
      assertThat(early.current).isEqualTo(SimState.SIM_CREATED);
      rowsToEnd(run);
      assertThatThrownBy(() -> run.restore(new byte[8])).isInstanceOf(InvalidState.class);
    }
  }
}
