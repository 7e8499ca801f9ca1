package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.model.LoopModel;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.scenes.SharedScene;

/** In a strict run the first warning is an error. */
class StrictRunTest {
  private static LoopModel model(Mechanism mechanism, double tEnd) {
    return LoopModels.of(mechanism, "DSR", SceneRun.settings(tEnd, 0.1, "ode113", 1e-8));
  }

  @Test
  void startThatHadToBeCorrectedEndsItBeforeTheFirstRow() {
    Mechanism mechanism = SharedScene.named("fps_inconsistent_rod").mechanism();
    SceneRun run = SceneRun.strict(model(mechanism, 0.1));
    assertThat(((Outcome.Failed) run.report.outcome()).failure().message())
        .contains("N-040")
        .contains("\"C3\"")
        .contains("1.0e-03 m")
        .contains("strict");
    assertThat(run.rows).isEmpty();
    assertThat(SceneRun.of(model(mechanism, 0.1)).report.outcome())
        .isEqualTo(new Outcome.Completed());
  }

  @Test
  void passageThroughASingularPositionEndsItThere() {
    SceneRun run = SceneRun.strict(model(Linkages.windows(1, 5), 2));
    assertThat(((Outcome.Failed) run.report.outcome()).failure().code())
        .isEqualTo(MessageCode.SINGULAR_POSITION_PASSED);
    assertThat(run.rows).isNotEmpty();
  }

  @Test
  void redundantEquationsAreNoWarning() {
    Mechanism mechanism = SharedScene.named("fourbar_redundant").mechanism();
    SceneRun run = SceneRun.strict(model(mechanism, 0.2));
    assertThat(run.report.notes())
        .extracting(Note::code)
        .contains(MessageCode.REDUNDANT_CONSTRAINTS);
    assertThat(run.report.outcome()).isEqualTo(new Outcome.Completed());
  }
}
