package org.mechservice.solver.ode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.Run;

/** What an integrator does with values that are not finite, and where no solution is left. */
public abstract class FailureContract extends UsageContract {
  // Values that are not finite

  @Test
  void rightHandSideNotFiniteAtTheStartFailsNamingTheComponent() {
    FunctionOde broken =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = 1;
              yDot[1] = Double.NaN;
            });
    Run run = Run.of(create(1e-6), broken, 0, new double[] {1, 1}, 3);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    IntegrationFailure failure = run.integrator().failure();
    assertThat(failure.cause()).isEqualTo(IntegrationFailure.Cause.NOT_FINITE);
    assertThat(failure.worstComponent()).isEqualTo(1);
    assertThat(failure.stepSize()).isZero();
    assertThat(failure.order()).isZero();
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void rightHandSideNotFiniteFromSomewhereOnFailsThereNamingTheComponent(double value) {
    FunctionOde broken =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = 1;
              yDot[1] = t > 1 ? value : 1;
            });
    Run run = Run.of(create(1e-6), broken, 0, new double[] {1, 1}, 3);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    IntegrationFailure failure = run.integrator().failure();
    assertThat(failure.cause()).isEqualTo(IntegrationFailure.Cause.NOT_FINITE);
    assertThat(failure.worstComponent()).isEqualTo(1);
    assertThat(failure.time()).isCloseTo(1, within(1e-9));
    assertThat(failure.lastSteps()).hasSizeLessThanOrEqualTo(10);
    assertThat(run.atEnd()).containsExactly(new double[] {2, 2}, within(1e-9));
  }

  /** A wheel on a spring that is not defined near half a turn: t can go on there, y cannot. */
  @Test
  void stateThatCannotBePassedEndsTheRunInsteadOfLettingTimeCreep() {
    FunctionOde guarded =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = y[1];
              yDot[1] = y[0] > Math.PI - 1e-3 ? Double.NaN : -40 * y[0];
            });
    Run run = Run.of(create(1e-8), guarded, 0, new double[] {2.9, 9}, 1);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    assertThat(run.integrator().failure().cause()).isEqualTo(IntegrationFailure.Cause.NOT_FINITE);
    assertThat(run.atEnd()[0]).isCloseTo(Math.PI - 1e-3, within(1e-6));
    assertThat(run.statistics().evaluations()).isLessThan(2000);
  }

  @Test
  void tenTriesInARowThatAreNotFiniteEndTheRun() {
    FunctionOde broken =
        new FunctionOde(
            1,
            (t, y, yDot) -> {
              yDot[0] = t > 0 ? Double.NaN : 1;
            });
    Run run = Run.of(create(1e-6), broken, 0, new double[] {1}, 3);
    List<IntegrationFailure.StepRecord> tries = run.integrator().failure().lastSteps();
    assertThat(tries).hasSize(10);
    assertThat(run.statistics().rejectedSteps()).isEqualTo(10);
    for (int i = 1; i < tries.size(); i++) {
      assertThat(tries.get(i).stepSize())
          .isEqualTo(notFiniteReduction() * tries.get(i - 1).stepSize());
      assertThat(tries.get(i).attempt()).isEqualTo(TrialOutcome.NOT_FINITE);
      assertThat(tries.get(i).error()).isNaN();
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {5, 6, 40, 41})
  void onePointThatIsNotFiniteIsSteppedAround(int evaluation) {
    // Odd and even: the evaluation at a prediction and at a corrected state.
    AtomicInteger count = new AtomicInteger();
    FunctionOde blinking =
        new FunctionOde(
            1,
            (t, y, yDot) ->
                yDot[0] =
                    count.incrementAndGet() == evaluation ? Double.NaN : y[0] * StrictMath.cos(t));
    Run run = Run.of(create(1e-8), blinking, 0, new double[] {1}, 20);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(run.atEnd()[0])
        .isCloseTo(SMOOTH.reference().atEnd()[0], within(accumulation() * 1e-8));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-6, 1e-9})
  void leavingTheDomainOfTheRightHandSideIsReported(double tolerance) {
    // y' = −√y reaches 0 at t = 2 and is not defined beyond (suite: nan_domain).
    FunctionOde root = new FunctionOde(1, (t, y, yDot) -> yDot[0] = -Math.sqrt(y[0]));
    Run run = Run.of(create(tolerance), root, 0, new double[] {1}, 3);
    if (run.result() == StepResult.REACHED_END) {
      // The suite lets the solution rest at 0, which the equation does not exclude.
      assertThat(run.atEnd()[0]).isBetween(0.0, 10 * tolerance);
      return;
    }
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    assertThat(run.integrator().failure().time()).isBetween(1.9, 2.1);
    assertThat(run.integrator().failure().worstComponent()).isZero();
  }

  @Test
  void blowUpInFiniteTimeIsReportedWhereItHappens() {
    // y' = y², pole at t = 1 (suite: blowup). The pole of the numerical solution lies off by some
    // tolerances; what is reported lies before both.
    FunctionOde blowUp = new FunctionOde(1, (t, y, yDot) -> yDot[0] = y[0] * y[0]);
    Run run = Run.of(create(1e-6), blowUp, 0, new double[] {1}, 2);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    IntegrationFailure failure = run.integrator().failure();
    assertThat(failure.cause())
        .isIn(
            IntegrationFailure.Cause.STEP_TOO_SMALL,
            IntegrationFailure.Cause.NOT_FINITE,
            IntegrationFailure.Cause.NO_CONVERGENCE);
    assertThat(failure.time()).isBetween(0.999, 1.0);
    assertThat(failure.allowedError()).isPositive();
    assertThat(failure.worstComponent()).isZero();
    assertThat(failure.lastSteps()).hasSize(10);
    assertThat(run.atEnd()[0]).isFinite();
    assertThat(run.statistics().evaluations()).isLessThan(2000);
  }
}
