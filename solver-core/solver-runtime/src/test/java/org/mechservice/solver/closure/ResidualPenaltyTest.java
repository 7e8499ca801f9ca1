package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.closure.model.ResidualPenaltyModel;
import org.mechservice.solver.scenes.SharedScene;

class ResidualPenaltyTest {
  /** So little that squares do not show, and more than what residuals leave out as rounding. */
  private static final double SMALL = 1e-3;

  @ParameterizedTest
  @CsvSource({
    "slider_crank_planar, RR",
    "slider_crank_planar, RR-JF",
    "fourbar_redundant, RR",
    "fourbar_redundant, RR-JF",
    "A03_andrews, RR",
    "A03_andrews, RR-JF",
    "fps, RR",
    "fps, RR-JF"
  })
  void oneSolutionLeadsBackToTheStatesOfAnImplicitStep(String name, String formulation) {
    ResidualPenaltyModel model =
        (ResidualPenaltyModel)
            LoopModels.of(
                SharedScene.named(name).mechanism(),
                formulation + " penalty",
                SceneRun.settings(1, 0.1, "ode15sR", 1e-6));
    double[] y = new double[model.unknownCount()];
    double[] yDot = new double[y.length];
    model.initialState(y);
    assertThat(model.consistent(0, y, yDot)).isEqualTo(ExplicitModel.REGULAR);
    double hGamma = 1e-4;
    assertThat(model.linearise(0, y, yDot)).isTrue();
    assertThat(model.factor(hGamma)).isTrue();
    Random random = new Random(5);
    double[] x = random.doubles(y.length, -SMALL, SMALL).toArray();
    int states = model.description().stateCount();
    Arrays.fill(x, states + model.work.loops.count(), y.length, 0);
    for (int i = 0; i < y.length; i++) {
      x[i] *= i < model.work.nq ? hGamma : 1; // as far as velocities move it in a step
      y[i] += x[i];
      yDot[i] += x[i] / hGamma;
    }
    double[] back = new double[y.length];
    assertThat(model.residual(0, y, yDot, back)).isEqualTo(ExplicitModel.REGULAR);
    for (int i = 0; i < y.length; i++) {
      back[i] *= -hGamma;
    }
    model.solve(back);
    for (int i = 0; i < states; i++) {
      // hγ times the speed, over the lengths, of what is left to the iteration, and squares
      assertThat(back[i]).as("unknown %s", i).isCloseTo(-x[i], within(3e-3 * SMALL));
    }
  }

  /** Its multipliers are sought although there is no step to try them in. */
  @ParameterizedTest
  @ValueSource(strings = {"RR penalty", "RR-JF penalty"})
  void aRunOfNoLengthIsItsStart(String formulation) {
    SceneRun run =
        LoopModels.run(
            SharedScene.named("fourbar_redundant").mechanism(),
            formulation,
            SceneRun.settings(0, 0.1, "ode15sR", 1e-6));
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    assertThat(run.rows).hasSize(1);
  }
}
