package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;

/** A mass on a spring, displaced by so little, or so loosely followed, that no test sees it. */
class MotionObserverTest {
  private static List<Note> warnings(double displacement, double absoluteTolerance)
      throws IOException {
    HarmonicOscillator model =
        new HarmonicOscillator() {
          @Override
          public void initialState(double[] y) {
            y[0] = displacement;
            y[1] = 0;
          }
        };
    RunSettings settings = new RunSettings(0, 2, 0.25, "ode113", 1e-6, absoluteTolerance);
    RunReport report =
        new RuntimeSolver()
            .run(model, new RunRequest(settings, Set.of()), new RecordedRows(), new RunControl());
    return report.notes().stream()
        .filter(note -> note.code() == MessageCode.ABSOLUTE_TOLERANCE_TOO_LARGE)
        .toList();
  }

  @Test
  void toleranceLargerThanAllThatMovesIsWarnedOfWithWhatToWrite() throws IOException {
    List<Note> warnings = warnings(1e-6, 1e-4);
    assertThat(warnings).hasSize(1).allMatch(Note::warning);
    assertThat(warnings.get(0).text())
        .startsWith("The absolute tolerance, 1.0e-04 m")
        .contains("largest motion is 1.4e-06 m, of \"slide.q\"")
        .endsWith("write absTol=\"1e-12\".");
  }

  @Test
  void toleranceBelowTheMotionIsNotWarnedOf() throws IOException {
    assertThat(warnings(1e-6, 1e-7)).isEmpty();
  }

  @Test
  void mechanismAtRestIsNotWarnedOf() throws IOException {
    assertThat(warnings(0, 1e-4)).isEmpty();
  }
}
