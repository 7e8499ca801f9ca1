package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.scenes.SharedScene;

class ResidualPenaltyTest {
  private static final double STEP = 0x1p-10;

  /** hγ ∂F/∂y + ∂F/∂y' times x, by central differences along x. */
  private static double[] product(
      ResidualPenaltyModel model, double[] y, double[] yDot, double hGamma, double[] x) {
    int n = y.length;
    double[] plus = new double[n];
    double[] minus = new double[n];
    double[] forward = new double[n];
    double[] backward = new double[n];
    double[] slopeForward = new double[n];
    double[] slopeBackward = new double[n];
    for (int i = 0; i < n; i++) {
      forward[i] = y[i] + STEP * hGamma * x[i];
      backward[i] = y[i] - STEP * hGamma * x[i];
      slopeForward[i] = yDot[i] + STEP * x[i];
      slopeBackward[i] = yDot[i] - STEP * x[i];
    }
    assertThat(model.residual(0, forward, slopeForward, plus)).isEqualTo(ExplicitModel.REGULAR);
    assertThat(model.residual(0, backward, slopeBackward, minus)).isEqualTo(ExplicitModel.REGULAR);
    for (int i = 0; i < n; i++) {
      plus[i] = (plus[i] - minus[i]) / (2 * STEP);
    }
    return plus;
  }

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
  void statesOfAnImplicitStepAreSolvedFor(String name, String formulation) {
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
    double[] x = random.doubles(y.length, -1, 1).toArray();
    int states = model.description().stateCount();
    Arrays.fill(x, states + model.work.loops.count(), y.length, 0);
    for (int i = 0; i < model.work.nq; i++) {
      x[i] *= hGamma; // as far as velocities move it in a step
    }
    double[] solved = product(model, y, yDot, hGamma, x);
    model.solve(solved);
    for (int i = 0; i < states; i++) {
      // hγ times the speed, over the lengths, of what is left to the iteration
      assertThat(solved[i]).as("unknown %s", i).isCloseTo(x[i], within(1e-2));
    }
  }
}
