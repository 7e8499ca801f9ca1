package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.simulation.RuntimeSolver;

/** A run with loops, taken up between any two steps, has the rows of one never interrupted. */
@Tag("slow")
class LoopCheckpointTest {
  /**
   * Steps from which runs of small and of large loops are taken up; the long tests do so at all.
   */
  private static final int PLACES = 8;

  private static final int PLACES_OF_LARGE_LOOPS = 2;

  private static final class Rows implements ResultSink {
    final List<double[]> rows = new ArrayList<>();

    @Override
    public void begin(List<Variable> columns) {}

    @Override
    public void row(double[] values) {
      rows.add(values.clone());
    }
  }

  private record Kept(List<byte[]> all, double secondsBetween, Optional<byte[]> saved)
      implements Checkpoints {
    @Override
    public String modelHash() {
      return "cafe";
    }

    @Override
    public void keep(byte[] checkpoint) {
      all.add(checkpoint);
    }
  }

  private static RunReport run(
      Mechanism mechanism, String formulation, RunSettings settings, Rows rows, Kept kept)
      throws IOException {
    return new RuntimeSolver()
        .run(
            LoopModels.of(mechanism, formulation, settings),
            new RunRequest(settings, Set.of()),
            rows,
            new RunControl(),
            kept);
  }

  /** What the loops had to say; the largest drift of a norm is that of the rows written. */
  private static List<Note> ofLoops(RunReport report) {
    return report.notes().stream()
        .filter(note -> note.code() != MessageCode.EULER_PARAMETER_NORM)
        .toList();
  }

  @ParameterizedTest
  @CsvSource({
    "slider_crank_singular, DSR, ode113",
    "slider_crank_singular, DSR, DE",
    "slider_crank_singular, DSR, ode15s",
    "slider_crank_singular, RR, ode15sR",
    "slider_crank_singular, RR-JF, ode15sR",
    "slider_crank_singular, DSR penalty, ode113",
    "slider_crank_singular, RR-JF penalty, ode15sR",
    "fps, DSR, ode113",
    "fps, DSR penalty, DE",
    "fps, RR-JF, ode15sR",
  })
  void runTakenUpAtSomeStepsHasTheSameRows(String name, String formulation, String integrator)
      throws IOException {
    RunSettings settings = SceneRun.settings(1.5, 0.05, integrator, 1e-6);
    takeUp(SharedScene.named(name).mechanism(), formulation, settings, PLACES);
  }

  @Tag("soak")
  @ParameterizedTest
  @CsvSource({
    "slider_crank_singular, DSR, ode15s",
    "slider_crank_singular, RR-JF penalty, ode15sR",
    "fps, DSR, ode113",
    "fps, DSR penalty, DE",
    "fps, RR-JF, ode15sR",
  })
  void runTakenUpEverywhereHasTheSameRows(String name, String formulation, String integrator)
      throws IOException {
    RunSettings settings = SceneRun.settings(1.5, 0.05, integrator, 1e-6);
    takeUp(SharedScene.named(name).mechanism(), formulation, settings, Integer.MAX_VALUE);
  }

  /** Pivots of sparse factors are taken up in their order, on which the last bits depend. */
  @ParameterizedTest
  @CsvSource({
    "DSR, ode113",
    "DSR penalty, ode113",
    "RR-JF, ode15sR",
    "RR penalty, ode15sR",
    "RR-JF penalty, ode15sR",
  })
  void runOfALargeLoopTakenUpAtSomeStepsHasTheSameRows(String formulation, String integrator)
      throws IOException {
    takeUpRing(formulation, integrator, PLACES_OF_LARGE_LOOPS);
  }

  @Tag("soak")
  @ParameterizedTest
  @CsvSource({
    "DSR, ode113",
    "DSR penalty, ode113",
    "RR-JF, ode15sR",
    "RR penalty, ode15sR",
    "RR-JF penalty, ode15sR",
  })
  void runOfALargeLoopTakenUpAnywhereHasTheSameRows(String formulation, String integrator)
      throws IOException {
    takeUpRing(formulation, integrator, Integer.MAX_VALUE);
  }

  private static void takeUpRing(String formulation, String integrator, int places)
      throws IOException {
    RunSettings settings = SceneRun.settings(0.2, 0.02, integrator, 1e-6);
    takeUp(Linkages.ring(110), formulation, settings, places);
  }

  /**
   * Takes up a run from its checkpoints.
   *
   * @param places how many of them, in the middle of as many equal parts; all if it has no more
   */
  private static void takeUp(
      Mechanism mechanism, String formulation, RunSettings settings, int places)
      throws IOException {
    Rows all = new Rows();
    Kept everyStep = new Kept(new ArrayList<>(), 0, Optional.empty());
    RunReport whole = run(mechanism, formulation, settings, all, everyStep);
    // A checkpoint follows every step.
    assertThat(everyStep.all).hasSizeGreaterThanOrEqualTo((int) whole.steps() - 1);
    int count = Math.min(places, everyStep.all.size());
    assertThat(count).isPositive();
    for (int place = 0; place < count; place++) {
      int i = (int) ((2L * place + 1) * everyStep.all.size() / (2L * count));
      Rows rest = new Rows();
      Kept from =
          new Kept(new ArrayList<>(), Double.POSITIVE_INFINITY, Optional.of(everyStep.all.get(i)));
      RunReport resumed = run(mechanism, formulation, settings, rest, from);
      int missing = all.rows.size() - rest.rows.size();
      for (int row = 0; row < rest.rows.size(); row++) {
        assertThat(rest.rows.get(row)).as("step %s", i).isEqualTo(all.rows.get(missing + row));
      }
      assertThat(resumed.outcome()).isEqualTo(whole.outcome());
      assertThat(resumed.steps()).isEqualTo(whole.steps());
      assertThat(resumed.evaluations()).isEqualTo(whole.evaluations());
      assertThat(ofLoops(resumed)).isEqualTo(ofLoops(whole));
    }
  }
}
