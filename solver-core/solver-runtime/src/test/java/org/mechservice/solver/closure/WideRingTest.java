package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunSettings;

/** Rings of many bodies: their equations have arms as long as the ring is wide. */
class WideRingTest {
  @ParameterizedTest
  @CsvSource({
    "20, DSR penalty, ode113",
    "20, DSR penalty, ode15s",
    "60, DSR penalty, ode113",
    "60, DSR penalty, ode15s",
    "60, RR penalty, ode15sR",
    "60, RR-JF penalty, ode15sR"
  })
  void ringMovesUnderPenaltyAsInIndependentCoordinates(
      int sides, String formulation, String integrator) {
    SceneRun run = run(sides, formulation, SceneRun.settings(0.5, 0.1, integrator, 1e-6));
    SceneRun independent = run(sides, "DSR", SceneRun.settings(0.5, 0.1, "ode113", 1e-8));
    for (int row = 0; row < run.rows.size(); row++) {
      double[] expected = independent.rows.get(row);
      for (int i = 0; i <= sides - 1; i++) {
        assertThat(run.rows.get(row)[i]).isCloseTo(expected[i], within(1e-5));
      }
    }
  }

  private static SceneRun run(int sides, String formulation, RunSettings settings) {
    SceneRun run = LoopModels.run(Linkages.ring(sides), formulation, settings);
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    return run;
  }
}
