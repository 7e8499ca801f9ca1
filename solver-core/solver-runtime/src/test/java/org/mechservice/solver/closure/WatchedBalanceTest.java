package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.model.LoopModel;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.text.Origin;

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

  private static final Expression TIME = new Expression.Time();

  /** A pendulum that moves as ¼ t², by a coupling, and another that is free. */
  private static Mechanism coupledToTime() {
    Expression angle = new Expression.CoordinatePosition(new JointCoordinate(0, 0));
    Expression way =
        new Expression.Product(Expression.of(-0.25), new Expression.Product(TIME, TIME));
    Expression relation = new Expression.Sum(angle, way);
    return Linkages.twoPendulums(List.of(new CoordinateClosure("lift", relation, Origin.NONE)));
  }

  private static Stream<Arguments> driven() {
    List<Mechanism> mechanisms =
        List.of(Linkages.drivenFourBar(0.8), Linkages.fourBarDrivenAtCut(0.8), coupledToTime());
    return mechanisms.stream()
        .flatMap(
            mechanism ->
                Stream.of(
                    Arguments.of(mechanism, "DSR", "ode113"),
                    Arguments.of(mechanism, "RR", "ode15sR"),
                    Arguments.of(mechanism, "RR-JF", "ode15sR"),
                    Arguments.of(mechanism, "DSR penalty", "ode113"),
                    Arguments.of(mechanism, "RR penalty", "ode15sR"),
                    Arguments.of(mechanism, "RR-JF penalty", "ode15sR")));
  }

  /**
   * What is prescribed in time works by driving forces and multipliers: their work is what the
   * energy changes by. Some hundred steps of a tolerance of 1e-8 may add up to 1e-6 of it. Rows
   * must not feel that power is measured.
   */
  @ParameterizedTest
  @MethodSource("driven")
  void workOfMotionsPrescribedInLoopsIsInTheBalance(
      Mechanism mechanism, String formulation, String integrator) {
    RunSettings settings = SceneRun.settings(1, 0.1, integrator, 1e-8);
    SceneRun plain = SceneRun.of(LoopModels.of(mechanism, formulation, settings));
    SceneRun watched = SceneRun.watched(LoopModels.of(mechanism, formulation, settings), 1e-6);
    assertThat(plain.report.energyDrift()).isEmpty();
    assertThat(watched.report.outcome()).isEqualTo(new Outcome.Completed());
    assertThat(watched.report.energyScale().orElseThrow()).isPositive();
    assertThat(watched.report.evaluations()).isEqualTo(plain.report.evaluations());
    for (int i = 0; i < plain.rows.size(); i++) {
      assertThat(watched.rows.get(i)).containsExactly(plain.rows.get(i));
    }
  }
}
