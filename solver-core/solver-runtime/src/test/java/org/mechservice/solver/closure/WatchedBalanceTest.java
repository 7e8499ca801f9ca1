package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.model.LoopModel;
import org.mechservice.solver.scenes.SharedScene;

/** The energy balance of mechanisms with loops, watched while they run. */
class WatchedBalanceTest {
  private static LoopModel model(String scene, String formulation, String integrator) {
    return LoopModels.of(
        SharedScene.named(scene).mechanism(),
        formulation,
        SceneRun.settings(0.5, 0.05, integrator, 1e-8));
  }

  /** Loops are closed again at the points where power is measured; rows must not feel it. */
  @Test
  void runThatKeepsItsBalanceHasTheSameBits() {
    SceneRun plain = SceneRun.of(model("fourbar_redundant", "DSR", "ode113"));
    SceneRun watched = SceneRun.watched(model("fourbar_redundant", "DSR", "ode113"), 1e-5);
    assertThat(watched.report.outcome()).isEqualTo(new Outcome.Completed());
    assertThat(watched.report.evaluations()).isEqualTo(plain.report.evaluations());
    assertThat(watched.rows).hasSameSizeAs(plain.rows);
    for (int i = 0; i < plain.rows.size(); i++) {
      assertThat(watched.rows.get(i)).containsExactly(plain.rows.get(i));
    }
  }

  /** No bound is below what an integration to 1e-8 makes of the energy. */
  @Test
  void boundBelowTheAccuracyOfTheRunEndsIt() {
    SceneRun watched = SceneRun.watched(model("fourbar_redundant", "DSR", "ode113"), 1e-15);
    assertThat(((Outcome.Failed) watched.report.outcome()).failure().code())
        .isEqualTo(MessageCode.ENERGY_DRIFT);
    assertThat(watched.rows).isNotEmpty();
  }

  /** The work of a drive in a loop is in a multiplier, which no row tells. */
  @Test
  void loopThatIsDrivenInTimeHasNoBalance() {
    LoopModel driven =
        LoopModels.of(
            Linkages.drivenFourBar(0.2), "DSR", SceneRun.settings(0.2, 0.1, "ode113", 1e-8));
    assertThat(SceneRun.of(driven).report.energyDrift()).isEmpty();
    assertThatThrownBy(() -> SceneRun.watched(driven, 1e-3))
        .hasMessageContaining("S-166")
        .hasMessageContaining("prescribed in time");
  }
}
