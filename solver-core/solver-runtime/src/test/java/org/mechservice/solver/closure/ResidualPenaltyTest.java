package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.closure.model.ResidualPenaltyModel;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

class ResidualPenaltyTest {
  /** So little that squares do not show, and more than what residuals leave out as rounding. */
  private static final double SMALL = 1e-3;

  /** Direction of bars that fall. */
  private static final Vector3 ALONG = new Vector3(0.6, 0, 0.8);

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

  /**
   * Two bars of 1 m side by side, joined by rods at three of their points: any one of the rods
   * makes the bars turn alike, and beside that position the rods contradict each other.
   */
  private static Mechanism parallelBars(int rods) {
    List<Body> bars = new ArrayList<>();
    List<Joint> hinges = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      Vector3 foot = Linkages.X.times(i);
      bars.add(Linkages.bar("bar" + i, foot, foot.plus(ALONG), 1));
      hinges.add(new Linkages.Hinge("foot" + i, JointType.R, -1, i, foot, Linkages.Y).joint());
    }
    List<LoopClosure> closures = new ArrayList<>();
    for (int i = 0; i < rods; i++) {
      Vector3 up = ALONG.times(1 - 0.3 * i);
      closures.add(
          new DistanceClosure(
              "rod" + i,
              new BodyPoint(0, up),
              new BodyPoint(1, Linkages.X.plus(up)),
              1,
              0,
              Origin.NONE));
    }
    return Linkages.mechanism("parallel bars", bars, hinges, closures);
  }

  @ParameterizedTest
  @CsvSource({
    "RR, 1e-6",
    "RR, 1e-8",
    "RR, 1e-9",
    "RR, 1e-10",
    "RR-JF, 1e-6",
    "RR-JF, 1e-8",
    "RR-JF, 1e-9",
    "RR-JF, 1e-10"
  })
  void rodsThatRepeatEachOtherMoveTheBarsAsOneDoes(String formulation, double tolerance) {
    SceneRun expected =
        LoopModels.run(parallelBars(1), "DSR", SceneRun.settings(1.5, 0.5, "ode113", 1e-11));
    SceneRun run =
        LoopModels.run(
            parallelBars(3),
            formulation + " penalty",
            SceneRun.settings(1.5, 0.5, "ode15sR", tolerance));
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    for (int i = 1; i <= 2; i++) {
      // error ≤ 10 rtol of the speed so far, the run's promise
      assertThat(run.at(1.5)[i]).isCloseTo(expected.at(1.5)[i], within(100 * tolerance));
    }
  }
}
