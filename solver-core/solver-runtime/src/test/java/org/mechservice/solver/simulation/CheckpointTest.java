package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelState;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;

/** A run taken up from a checkpoint has the rows and the report of one never interrupted. */
class CheckpointTest {
  /** Keeps every checkpoint in memory. */
  private static final class Kept implements Checkpoints {
    final List<byte[]> checkpoints = new ArrayList<>();
    private final String hash;
    private final double secondsBetween;
    private final Optional<byte[]> saved;

    Kept(String hash, double secondsBetween, Optional<byte[]> saved) {
      this.hash = hash;
      this.secondsBetween = secondsBetween;
      this.saved = saved;
    }

    @Override
    public String modelHash() {
      return hash;
    }

    @Override
    public double secondsBetween() {
      return secondsBetween;
    }

    @Override
    public Optional<byte[]> saved() {
      return saved;
    }

    @Override
    public void keep(byte[] checkpoint) {
      checkpoints.add(checkpoint);
    }
  }

  private static Kept afterEveryStep() {
    return new Kept("cafe", 0, Optional.empty());
  }

  private static Kept goingOnFrom(byte[] saved) {
    return new Kept("cafe", Double.POSITIVE_INFINITY, Optional.of(saved));
  }

  private static RunRequest request(String integrator) {
    return new RunRequest(
        new RunSettings(0, 20, 0.25, integrator, 1e-8, 1e-10), EnumSet.of(ColumnGroup.ENERGY));
  }

  private static RunReport run(
      Model model, RunRequest request, RecordedRows rows, Checkpoints checkpoints)
      throws IOException {
    return new RuntimeSolver().run(model, request, rows, new RunControl(), checkpoints);
  }

  /** The oscillator in residual form, too. */
  private static final class ResidualOscillator extends HarmonicOscillator
      implements ResidualModel {
    @Override
    public int residual(double t, double[] y, double[] yDot, double[] residual) {
      residual[0] = yDot[0] - y[1];
      residual[1] = yDot[1] + y[0];
      return REGULAR;
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"ode113", "DE", "ode15s", "ode15sR", "switching"})
  void runTakenUpAnywhereHasTheSameRowsAndReport(String integrator) throws IOException {
    RecordedRows all = new RecordedRows();
    Kept kept = afterEveryStep();
    RunReport whole = run(new ResidualOscillator(), request(integrator), all, kept);
    assertThat(kept.checkpoints).hasSize((int) whole.steps() - 1);
    for (int i = 0; i < kept.checkpoints.size(); i += 7) {
      RecordedRows rest = new RecordedRows();
      byte[] saved = kept.checkpoints.get(i);
      RunReport resumed =
          run(new ResidualOscillator(), request(integrator), rest, goingOnFrom(saved));
      int missing = all.rows.size() - rest.rows.size();
      for (int row = 0; row < rest.rows.size(); row++) {
        assertThat(rest.rows.get(row)).isEqualTo(all.rows.get(missing + row));
      }
      assertThat(rest.columns).isEqualTo(all.columns);
      assertThat(resumed.outcome()).isEqualTo(whole.outcome());
      assertThat(resumed.steps()).isEqualTo(whole.steps());
      assertThat(resumed.rejectedSteps()).isEqualTo(whole.rejectedSteps());
      assertThat(resumed.evaluations()).isEqualTo(whole.evaluations());
      assertThat(resumed.rows()).isEqualTo(whole.rows());
      assertThat(resumed.energyDrift()).isEqualTo(whole.energyDrift());
      assertThat(resumed.energyScale()).isEqualTo(whole.energyScale());
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"ode113", "DE", "ode15s", "ode15sR", "switching"})
  void runThatIsStoppedBeforeItsFirstStepLeavesACheckpoint(String integrator) throws IOException {
    RecordedRows all = new RecordedRows();
    RunReport whole = run(new ResidualOscillator(), request(integrator), all, Checkpoints.NONE);
    Kept kept = new Kept("cafe", 3600, Optional.empty());
    RunControl stopped =
        new RunControl() {
          @Override
          public boolean proceed(double time, double stepSize, int order, long steps) {
            return false;
          }
        };
    RecordedRows first = new RecordedRows();
    RunReport report =
        new RuntimeSolver()
            .run(new ResidualOscillator(), request(integrator), first, stopped, kept);
    assertThat(report.outcome()).isEqualTo(new Outcome.Stopped());
    assertThat(first.rows).hasSize(1);
    assertThat(kept.checkpoints).hasSize(1);

    RecordedRows rest = new RecordedRows();
    RunReport resumed =
        run(
            new ResidualOscillator(),
            request(integrator),
            rest,
            goingOnFrom(kept.checkpoints.get(0)));
    first.rows.addAll(rest.rows);
    assertThat(first.rows).usingRecursiveComparison().isEqualTo(all.rows);
    assertThat(resumed.steps()).isEqualTo(whole.steps());
    assertThat(resumed.evaluations()).isEqualTo(whole.evaluations());
    assertThat(resumed.energyDrift()).isEqualTo(whole.energyDrift());
  }

  @Test
  void checkpointsChangeNothing() throws IOException {
    RecordedRows with = new RecordedRows();
    RecordedRows without = new RecordedRows();
    run(new HarmonicOscillator(), request("ode113"), with, afterEveryStep());
    run(new HarmonicOscillator(), request("ode113"), without, Checkpoints.NONE);
    assertThat(with.rows).usingRecursiveComparison().isEqualTo(without.rows);
  }

  @Test
  void runThatIsStoppedLeavesACheckpointToGoOnFrom() throws IOException {
    Kept kept = new Kept("cafe", 3600, Optional.empty());
    RunControl control = new RunControl();
    RecordedRows first = new RecordedRows();
    ExplicitModel stopping =
        new HarmonicOscillator() {
          @Override
          public int derivative(double t, double[] y, double[] yDot) {
            if (t > 5) {
              control.pause();
            }
            return super.derivative(t, y, yDot);
          }
        };
    Thread stopper =
        new Thread(
            () -> {
              try {
                while (!control.awaitHeld(10)) {
                  Thread.onSpinWait();
                }
                control.stop();
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            });
    stopper.start();
    RunReport stopped = new RuntimeSolver().run(stopping, request("ode113"), first, control, kept);
    assertThat(stopped.outcome()).isInstanceOf(Outcome.Stopped.class);
    assertThat(kept.checkpoints).hasSize(1);
    RecordedRows rest = new RecordedRows();
    run(new HarmonicOscillator(), request("ode113"), rest, goingOnFrom(kept.checkpoints.get(0)));
    RecordedRows all = new RecordedRows();
    run(new HarmonicOscillator(), request("ode113"), all, Checkpoints.NONE);
    assertThat(first.rows.size() + rest.rows.size()).isEqualTo(all.rows.size());
    assertThat(rest.rows.get(rest.rows.size() - 1)).isEqualTo(all.rows.get(all.rows.size() - 1));
  }

  /**
   * Evaluations wait, so that the request comes within a step; a plain stop leaves nothing then.
   */
  @Test
  void runThatIsStoppedAfterItsStepLeavesACheckpoint() throws Exception {
    Kept kept = new Kept("cafe", 3600, Optional.empty());
    RunControl control = new RunControl();
    CountDownLatch within = new CountDownLatch(1);
    ExplicitModel slow =
        new HarmonicOscillator() {
          @Override
          public int derivative(double t, double[] y, double[] yDot) {
            if (t > 5) {
              within.countDown();
              LockSupport.parkNanos(2_000_000);
            }
            return super.derivative(t, y, yDot);
          }
        };
    Thread stopper =
        new Thread(
            () -> {
              try {
                within.await();
                control.stopAfterStep(60_000, () -> false);
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            });
    stopper.start();
    RunReport stopped =
        new RuntimeSolver().run(slow, request("ode113"), new RecordedRows(), control, kept);
    stopper.join();
    assertThat(stopped.outcome()).isInstanceOf(Outcome.Stopped.class);
    assertThat(kept.checkpoints).hasSize(1);
  }

  // What does not fit

  private static byte[] checkpoint() throws IOException {
    Kept kept = afterEveryStep();
    run(new HarmonicOscillator(), request("ode113"), new RecordedRows(), kept);
    return kept.checkpoints.get(10);
  }

  @Test
  void checkpointOfAnotherModelIsRefusedByItsHash() throws IOException {
    Kept other = new Kept("beef", Double.POSITIVE_INFINITY, Optional.of(checkpoint()));
    assertThatIllegalArgumentException()
        .isThrownBy(
            () -> run(new HarmonicOscillator(), request("ode113"), new RecordedRows(), other))
        .withMessage("S-071 the hash of the model is beef, but that of the saved state is cafe");
  }

  @Test
  void checkpointOfARunWithOtherSettingsIsRefusedAndTheyAloneAreNamed() throws IOException {
    Kept kept = goingOnFrom(checkpoint());
    assertThatIllegalArgumentException()
        .isThrownBy(() -> run(new HarmonicOscillator(), request("DE"), new RecordedRows(), kept))
        .withMessage(
            "S-071 the run has other settings than the saved state, integrator=DE instead of"
                + " integrator=ode113");
  }

  @Test
  void checkpointOfAStrictRunGoesOnStrictlyAndInNoOtherWay() throws IOException {
    RunRequest standard = request("ode113");
    RunRequest strict =
        new RunRequest(standard.settings().withAccuracy(Accuracy.STRICT), standard.columns());
    RecordedRows all = new RecordedRows();
    Kept kept = afterEveryStep();
    run(new HarmonicOscillator(), strict, all, kept);
    byte[] saved = kept.checkpoints.get(10);
    RecordedRows rest = new RecordedRows();
    run(new HarmonicOscillator(), strict, rest, goingOnFrom(saved));
    assertThat(rest.rows.get(rest.rows.size() - 1)).isEqualTo(all.rows.get(all.rows.size() - 1));
    assertThatIllegalArgumentException()
        .isThrownBy(
            () -> run(new HarmonicOscillator(), standard, new RecordedRows(), goingOnFrom(saved)))
        .withMessage(
            "S-071 the run has other settings than the saved state, accuracy=standard instead of"
                + " accuracy=strict");
  }

  @Test
  void checkpointOfAnotherVersionIsRefused() throws IOException {
    // The version stands in the bytes as text, behind a checksum.
    byte[] damaged = checkpoint();
    String version = SolverVersion.CURRENT;
    int at = new String(damaged, StandardCharsets.ISO_8859_1).indexOf(version);
    assertThat(at).isPositive();
    damaged[at] ^= 1;
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                run(
                    new HarmonicOscillator(),
                    request("ode113"),
                    new RecordedRows(),
                    goingOnFrom(damaged)))
        .withMessageStartingWith("S-071 the saved state is damaged");
  }

  /** A loop whose choice of coordinates nobody can save. */
  private static class Loop extends HarmonicOscillator implements DependentStates {
    @Override
    public boolean independent(int component) {
      return true;
    }

    @Override
    public boolean complete(double t, double[] y) {
      return true;
    }

    @Override
    public boolean accepted(double t, double[] y) {
      return false;
    }
  }

  /** A loop that tells its choice, here the number of steps it has seen. */
  private static final class SavedLoop extends Loop implements ModelState {
    private int seen;

    @Override
    public boolean accepted(double t, double[] y) {
      seen++;
      return false;
    }

    @Override
    public int stateLength() {
      return 1;
    }

    @Override
    public void saveState(double[] state) {
      state[0] = seen;
    }

    @Override
    public void restoreState(double[] state) {
      seen = (int) state[0];
    }
  }

  @Test
  void modelThatDoesNotTellItsStateIsRefusedOnlyIfCheckpointsAreAskedFor() throws IOException {
    run(new Loop(), request("ode113"), new RecordedRows(), Checkpoints.NONE);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> run(new Loop(), request("ode113"), new RecordedRows(), afterEveryStep()))
        .withMessageStartingWith("S-072 model \"Oscillator\"");
  }

  @Test
  void stateOfTheModelIsTakenUpToo() throws IOException {
    Kept kept = afterEveryStep();
    SavedLoop whole = new SavedLoop();
    run(whole, request("ode113"), new RecordedRows(), kept);
    SavedLoop resumed = new SavedLoop();
    run(resumed, request("ode113"), new RecordedRows(), goingOnFrom(kept.checkpoints.get(20)));
    assertThat(resumed.seen).isEqualTo(whole.seen);
  }
}
