package org.mechservice.solver.ode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.jumps.UndeclaredJumps;
import org.mechservice.solver.ode.step.WatchedIntegrator;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.Run;

/** What the Adams methods do beyond every integrator. */
public abstract class AdamsContract extends IntegratorContract {
  /** One to two digits. */
  @Override
  protected double accumulation() {
    return 100;
  }

  @Override
  protected double notFiniteReduction() {
    return 0.25;
  }

  /** Returns the integrator with a search for jumps that nobody has declared. */
  private Integrator searched(IntegratorSettings settings) {
    return UndeclaredJumps.around((WatchedIntegrator) create(settings));
  }

  /** A block on a spring with friction as a jump: once at rest, it would have to stay there. */
  @Test
  void slidingAlongAJumpEndsTheRunInsteadOfCrossingItForEver() {
    FunctionOde dry =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = y[1];
              yDot[1] = -Math.signum(y[1]) - y[0];
            });
    Run run =
        Run.of(searched(new IntegratorSettings(1e-8, 1e-8)), dry, 0, new double[] {3.3, 0}, 20);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    assertThat(run.integrator().failure().cause())
        .isEqualTo(IntegrationFailure.Cause.STEP_TOO_SMALL);
    assertThat(run.integrator().time()).isCloseTo(2 * Math.PI, within(1e-3));
    assertThat(run.atEnd()).containsExactly(new double[] {-0.7, 0}, within(1e-4));
    assertThat(run.statistics().evaluations()).isLessThan(100_000);
  }

  /** y' = 1/2 − sgn y: from t = 2 on both sides lead back to 0, and short steps chatter there. */
  @ParameterizedTest
  @EnumSource
  void chatterAroundAJumpEndsTheRunEarly(Mode mode) {
    FunctionOde relay = new FunctionOde(1, (t, y, yDot) -> yDot[0] = 0.5 - Math.signum(y[0]));
    for (double tolerance : new double[] {1e-6, 1e-9}) {
      IntegratorSettings settings = new IntegratorSettings(tolerance, tolerance).withMode(mode);
      Run run = Run.of(searched(settings), relay, 0, new double[] {1}, 10);
      assertThat(run.result()).isEqualTo(StepResult.FAILED);
      assertThat(run.integrator().failure().slidesAlongJump()).isTrue();
      assertThat(run.integrator().time()).isCloseTo(2, within(0.01));
      assertThat(run.statistics().evaluations()).isLessThan(20_000);
    }
  }

  @Test
  void stepsGrowWithTheSeventhRootOfTheToleranceAtOrderSix() {
    assertStepsGrowWithTheRootOfTheTolerance(6);
  }

  @Test
  void roundOffDoesNotAccumulateAtTightTolerances() {
    // 100 000 steps of 1e-3, each adding 1e-4 to a million: added plainly, every sum is wrong by up
    // to half an ulp in the same direction, some 1e-6 in the end. Carried along, it stays at an
    // ulp.
    FunctionOde steady = new FunctionOde(1, (t, y, yDot) -> yDot[0] = 0.1);
    IntegratorSettings settings =
        new IntegratorSettings(5e-14, List.of(5e-14), 1e-3, 0, 0, Long.MAX_VALUE, () -> false);
    Run run = Run.of(create(settings), steady, 0, new double[] {1e6}, 100);
    assertThat(run.statistics().steps()).isGreaterThanOrEqualTo(100_000);
    assertThat(run.atEnd()[0]).isCloseTo(1e6 + 10, within(4 * Math.ulp(1e6)));
  }

  @Test
  void noEquationsAreSolved() {
    IntegrationStatistics statistics =
        Run.of(
                create(1e-6),
                new FunctionOde(1, (t, y, yDot) -> yDot[0] = -y[0]),
                0,
                new double[] {1},
                1)
            .statistics();
    assertThat(statistics.jacobians()).isZero();
    assertThat(statistics.factorisations()).isZero();
    assertThat(statistics.solutions()).isZero();
  }
}
