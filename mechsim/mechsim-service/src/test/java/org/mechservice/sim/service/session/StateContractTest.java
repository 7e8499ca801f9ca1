package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.SimState;
import org.mechservice.orb.testing.CursorRows;
import org.mechservice.orb.testing.Eventually;
import org.omg.CORBA.DoubleHolder;

/** What clients are promised about the state of a run between its rows. */
@Tag("slow")
class StateContractTest {
  private static final NameValue[] AS_IN_FILE = new NameValue[0];

  /** Two rows only: the start and the end. */
  private static final NameValue[] SPARSE = {
    new NameValue("t-end", "1"), new NameValue("t-step", "1")
  };

  private static void step(IMechSimRemote run) throws Exception {
    run.stepOnce();
    Eventually.holds(() -> run.getProgress().state == SimState.SIM_PAUSED);
  }

  @Test
  void heldRunTellsItsStateBetweenRows() throws Exception {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      MechSim session = there.session();
      IMechSimRemote run = session.createSimulation(SPARSE, null);
      DoubleHolder time = new DoubleHolder();
      double[] start = run.getStates(time);
      assertThat(time.value).isZero();
      for (int i = 0; i < 20; i++) {
        step(run);
      }
      double[] state = run.getStates(time);
      assertThat(run.getProgress().rowsReady).isEqualTo(1);
      assertThat(time.value).isEqualTo(run.getProgress().simTime).isBetween(1e-9, 0.999);
      assertThat(state).hasSameSizeAs(start).isNotEqualTo(start);
      assertThat(run.getStates(time)).isEqualTo(state);

      IMechSimRemote upTo =
          session.createSimulation(
              new NameValue[] {
                new NameValue("t-end", Double.toString(time.value)), new NameValue("t-step", "1")
              },
              null);
      upTo.start();
      List<double[]> rows = CursorRows.toEnd(upTo.openResults(HostedClient.ALL), 0);
      double[] last = rows.get(rows.size() - 1);
      assertThat(last[0]).isEqualTo(time.value);
      // Either is within ten times the tolerances of the file, 1e-5, of the motion.
      assertThat(Arrays.copyOfRange(last, 1, last.length)).containsExactly(state, within(1e-4));
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"pendulum/pendulum.xml", "elements/joint-cut.xml", "elements/JointConstraint.xml"})
  void whoAsksForTheStateAtEveryStepChangesNoBit(String file) throws Exception {
    Path model = Path.of("../../examples").resolve(file);
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      MechSim session = there.emptySession();
      session.loadModel(
          new ModelFile(model.getFileName().toString(), Files.readAllBytes(model)),
          new ModelFile[0]);
      IMechSimRemote undisturbed = session.createSimulation(AS_IN_FILE, null);
      undisturbed.start();
      List<double[]> expected = CursorRows.toEnd(undisturbed.openResults(HostedClient.ALL), 0);
      IMechSimRemote run = session.createSimulation(AS_IN_FILE, null);
      for (int i = 0; i < 10; i++) {
        step(run);
        run.getStates(new DoubleHolder());
      }
      run.resume();
      List<double[]> rows = CursorRows.toEnd(run.openResults(HostedClient.ALL), 0);
      assertThat(rows).usingElementComparator(Arrays::compare).isEqualTo(expected);
      assertThat(run.report()).contains("\"outcome\":\"completed\"");
    }
  }
}
