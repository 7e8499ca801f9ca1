package org.mechservice.solver.ode.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.StepResult;

/** An initial value problem is solved in one call. */
class OdeSolveTest {
  private static final OdeFunction DECAY = (t, y, yDot) -> yDot[0] = -y[0];

  /** A rotation: y = (cos t, −sin t). */
  private static final OdeFunction ROTATION =
      (t, y, yDot) -> {
        yDot[0] = y[1];
        yDot[1] = -y[0];
      };

  private static OdeOptions with(OdeMethod method) {
    return OdeOptions.standard().method(method).rtol(1e-8).atol(1e-10);
  }

  @Test
  void lambdaIsEnough() {
    OdeSolution solution = Ode.solve(DECAY, 0, new double[] {1}, 5);
    assertThat(solution.at(2.5)[0]).isCloseTo(StrictMath.exp(-2.5), within(1e-6));
    assertThat(solution.endState()[0]).isCloseTo(StrictMath.exp(-5), within(1e-6));
    assertThat(solution.endReason()).isEqualTo(EndReason.REACHED_END);
    assertThat(solution.failure()).isEmpty();
  }

  @ParameterizedTest
  @EnumSource
  void solutionIsAccurateOverTheWholeInterval(OdeMethod method) {
    OdeSolution solution = Ode.solve(ROTATION, 0, new double[] {1, 0}, 10, with(method));
    double[] y = new double[2];
    double[] yDot = new double[2];
    for (int i = 0; i <= 1000; i++) {
      double t = 0.01 * i;
      solution.at(t, y, yDot);
      assertThat(y[0]).isCloseTo(StrictMath.cos(t), within(3e-6));
      assertThat(y[1]).isCloseTo(-StrictMath.sin(t), within(3e-6));
      assertThat(yDot[0]).isCloseTo(y[1], within(1e-4));
    }
  }

  @ParameterizedTest
  @EnumSource
  void backwardsTheSolutionComesToItsStart(OdeMethod method) {
    double[] end = Ode.solve(ROTATION, 0, new double[] {1, 0}, 10, with(method)).endState();
    OdeSolution back = Ode.solve(ROTATION, 10, end, 0, with(method));
    assertThat(back.endState()[0]).isCloseTo(1, within(1e-5));
    assertThat(back.at(3)[0]).isCloseTo(StrictMath.cos(3), within(1e-5));
    assertThat(back.end()).isZero();
  }

  @ParameterizedTest
  @EnumSource
  void denseOutputHasTheBitsOfTheIntegrator(OdeMethod method) {
    OdeOptions options = with(method);
    OdeSolution solution = Ode.solve(ROTATION, 0, new double[] {1, 0}, 20, options);
    Integrator integrator = method.integrator(options.settings(() -> false));
    integrator.start(Ode.system(2, ROTATION), 0, new double[] {1, 0}, 20);
    double[] y = new double[2];
    double[] yDot = new double[2];
    double[] rate = new double[2];
    int steps = 0;
    StepResult result;
    do {
      result = integrator.step();
      double t = 0.6 * integrator.time() + 0.4 * integrator.previousTime();
      steps++;
      integrator.interpolate(t, y, yDot);
      assertThat(solution.at(t)).isEqualTo(y);
      solution.at(t, y, rate);
      assertThat(rate).isEqualTo(yDot);
    } while (result == StepResult.ADVANCED);
    assertThat(solution.steps()).hasSize(steps);
    assertThat(solution.statistics()).isEqualTo(integrator.statistics());
  }

  @ParameterizedTest
  @EnumSource
  void stepsFollowEachOtherFromStartToEnd(OdeMethod method) {
    OdeSolution solution = Ode.solve(ROTATION, 1, new double[] {1, 0}, 10, with(method));
    double[] times = solution.times();
    List<OdeSolution.Step> steps = solution.steps();
    assertThat(times).startsWith(1).endsWith(10).isSorted().hasSize(steps.size() + 1);
    for (int i = 0; i < steps.size(); i++) {
      assertThat(steps.get(i).start()).isEqualTo(times[i]);
      assertThat(steps.get(i).end()).isEqualTo(times[i + 1]);
      assertThat(steps.get(i).order()).isPositive();
    }
    assertThat(solution.statistics().steps()).isEqualTo(steps.size());
  }

  @Test
  void solutionIsReadByManyThreads() {
    OdeSolution solution = Ode.solve(ROTATION, 0, new double[] {1, 0}, 10, with(OdeMethod.ODE113));
    double[] one = IntStream.range(0, 4000).mapToDouble(i -> solution.at(0.0025 * i)[0]).toArray();
    double[] many =
        IntStream.range(0, 4000).parallel().mapToDouble(i -> solution.at(0.0025 * i)[0]).toArray();
    assertThat(many).isEqualTo(one);
  }

  @ParameterizedTest
  @EnumSource
  void emptyIntervalIsASolutionWithoutSteps(OdeMethod method) {
    OdeSolution solution = Ode.solve(ROTATION, 2, new double[] {1, 3}, 2, with(method));
    assertThat(solution.at(2)).containsExactly(1, 3);
    assertThat(solution.endState()).containsExactly(1, 3);
    assertThat(solution.steps()).isEmpty();
    assertThat(solution.endReason()).isEqualTo(EndReason.REACHED_END);
    assertThatIllegalStateException()
        .isThrownBy(() -> solution.at(2, new double[2], new double[2]))
        .withMessageContaining("has no step");
  }

  @Test
  void initialStateIsNotModifiedAndItsCopyIsKept() {
    double[] y0 = {1};
    OdeSolution solution = Ode.solve(DECAY, 0, y0, 1);
    assertThat(y0).containsExactly(1);
    y0[0] = 7;
    assertThat(solution.startState()).containsExactly(1);
    solution.endState()[0] = 9;
    assertThat(solution.endState()[0]).isLessThan(1);
  }

  @Test
  void solutionTellsWhatCameOfIt() {
    OdeSolution solution = Ode.solve(DECAY, 0, new double[] {1}, 5);
    assertThat(solution)
        .hasToString(
            "solution from t = 0.0 to 5.0 (REACHED_END), "
                + solution.statistics().steps()
                + " steps, "
                + solution.statistics().evaluations()
                + " evaluations, 0 events");
  }

  // Options

  @Test
  void optionsAreNotChangedByTheirMethods() {
    OdeOptions standard = OdeOptions.standard();
    OdeOptions tight = standard.rtol(1e-10).atol(1e-12).method(OdeMethod.ODE113);
    assertThat(standard.settings(() -> false).relativeTolerance()).isEqualTo(1e-6);
    assertThat(tight.settings(() -> false).relativeTolerance()).isEqualTo(1e-10);
    assertThat(standard.method()).isEqualTo(OdeMethod.AUTO);
  }

  @Test
  void eachComponentHasItsOwnAbsoluteTolerance() {
    OdeFunction forced =
        (t, y, yDot) -> {
          yDot[0] = -y[0] + StrictMath.sin(3 * t);
          yDot[1] = -y[1] + StrictMath.sin(3 * t);
        };
    double[] y0 = {0, 0};
    OdeOptions options = OdeOptions.standard().rtol(1e-10).method(OdeMethod.ODE113);
    long tight = Ode.solve(forced, 0, y0, 10, options.atol(1e-10, 1)).statistics().steps();
    long loose = Ode.solve(forced, 0, y0, 10, options.atol(1, 1)).statistics().steps();
    assertThat(loose).isLessThan(tight);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Ode.solve(forced, 0, y0, 10, options.atol(1, 1, 1)))
        .withMessageContaining("number of absolute tolerances is 3")
        .withMessageContaining("1 or one per component, 2");
  }

  @Test
  void strictAccuracyGivesMoreDigits() {
    OdeOptions options = OdeOptions.standard().method(OdeMethod.ODE113);
    double[] y0 = {1, 0};
    double standard = error(Ode.solve(ROTATION, 0, y0, 50, options));
    double strict = error(Ode.solve(ROTATION, 0, y0, 50, options.accuracy(Mode.STRICT)));
    assertThat(strict).isLessThan(standard);
  }

  private static double error(OdeSolution solution) {
    return Math.abs(solution.endState()[0] - StrictMath.cos(solution.end()));
  }

  @Test
  void stepsAreBoundedBySizeAndOrder() {
    OdeOptions options =
        OdeOptions.standard().method(OdeMethod.ODE113).maxStep(0.05).initialStep(1e-4).maxOrder(3);
    OdeSolution solution = Ode.solve(ROTATION, 0, new double[] {1, 0}, 5, options);
    assertThat(solution.steps().get(0).end()).isCloseTo(1e-4, within(1e-15));
    assertThat(solution.steps())
        .allSatisfy(step -> assertThat(step.end() - step.start()).isLessThan(0.0501))
        .allSatisfy(step -> assertThat(step.order()).isLessThanOrEqualTo(3));
  }

  @Test
  void autoChangesItsMethodWhereTheProblemIsStiff() {
    OdeFunction vanDerPol =
        (t, y, yDot) -> {
          yDot[0] = y[1];
          yDot[1] = 1000 * (1 - y[0] * y[0]) * y[1] - y[0];
        };
    OdeSolution solution = Ode.solve(vanDerPol, 0, new double[] {2, 0}, 2000);
    assertThat(solution.methodChanges()).isNotEmpty();
    assertThat(solution.statistics().steps()).isLessThan(5000);
  }

  @Test
  void withoutStepsKeptTheEndIsKnownAndTheRestSaysWhatToDo() {
    OdeSolution solution =
        Ode.solve(DECAY, 0, new double[] {1}, 5, OdeOptions.standard().keepSteps(false));
    assertThat(solution.endState()[0]).isCloseTo(StrictMath.exp(-5), within(1e-6));
    assertThatIllegalStateException()
        .isThrownBy(() -> solution.at(1))
        .withMessageContaining("not kept")
        .withMessageContaining("keepSteps(true)");
  }

  // Failures

  @Test
  void failureThrowsWithSolutionPlaceCauseAndAdvice() {
    // y = 1 / (1 − t) has a pole at t = 1.
    IntegrationException failure =
        catchThrowableOfType(
            IntegrationException.class,
            () ->
                Ode.solve(
                    (t, y, yDot) -> yDot[0] = y[0] * y[0],
                    0,
                    new double[] {1},
                    2,
                    with(OdeMethod.ODE113)));
    assertThat(failure.solution().end()).isCloseTo(1, within(1e-3));
    assertThat(failure.solution().at(0.5)[0]).isCloseTo(2, within(1e-6));
    assertThat(failure.solution().endReason()).isEqualTo(EndReason.FAILED);
    assertThat(failure.lostFrom()).isCloseTo(1, within(1e-3));
    assertThat(failure.lostTo()).isGreaterThanOrEqualTo(failure.lostFrom());
    assertThat(failure)
        .hasMessageContaining("from t = 0.0 to 2.0")
        .hasMessageContaining("ended at t = " + failure.solution().end())
        .hasMessageContaining(failure.advice());
  }

  /** Behind a pole that the tolerances move, the solution computed is not the exact one. */
  @Test
  void failureTellsTheIntervalInWhichItLiesWithEveryMethod() {
    for (OdeMethod method :
        List.of(OdeMethod.ODE113, OdeMethod.DE, OdeMethod.ODE15S, OdeMethod.AUTO)) {
      for (double tolerance : new double[] {1e-3, 1e-6, 1e-9}) {
        OdeOptions options = OdeOptions.standard().rtol(tolerance).atol(tolerance).method(method);
        IntegrationException failure =
            catchThrowableOfType(
                IntegrationException.class,
                () ->
                    Ode.solve(
                        (t, y, yDot) -> yDot[0] = y[0] * y[0], 0, new double[] {1}, 2, options));
        double pole = 1 + 100 * tolerance;
        assertThat(failure.lostFrom()).as("%s %s", method, tolerance).isLessThanOrEqualTo(pole);
        assertThat(failure.lostFrom()).isEqualTo(failure.failure().time());
        assertThat(failure.lostTo()).isCloseTo(1, within(100 * tolerance));
        assertThat(failure.lostFrom()).isLessThanOrEqualTo(failure.lostTo());
        if (failure.lostFrom() != failure.solution().end()) {
          assertThat(failure)
              .hasMessageContaining("lost between t = " + failure.lostFrom())
              .hasMessageContaining(" and t = " + failure.lostTo());
        }
      }
    }
  }

  @Test
  void stepsAllowedAreUsedUpWithAdvice() {
    OdeOptions options = OdeOptions.standard().method(OdeMethod.ODE113).maxSteps(10);
    IntegrationException failure =
        catchThrowableOfType(
            IntegrationException.class,
            () -> Ode.solve(ROTATION, 0, new double[] {1, 0}, 100, options));
    assertThat(failure.reason()).isEqualTo(Cause.TOO_MANY_STEPS);
    assertThat(failure)
        .hasMessageContaining("the 10 steps allowed are used up")
        .hasMessageContaining("Raise maxSteps");
  }

  @Test
  void failureIsReturnedIfAskedFor() {
    OdeSolution solution =
        Ode.solve(
            ROTATION,
            0,
            new double[] {1, 0},
            100,
            OdeOptions.standard().maxSteps(10).returnFailures());
    assertThat(solution.endReason()).isEqualTo(EndReason.FAILED);
    assertThat(solution.failure().orElseThrow().cause()).isEqualTo(Cause.TOO_MANY_STEPS);
    assertThat(solution.end()).isLessThan(100);
    assertThat(solution.at(solution.end())).isEqualTo(solution.endState());
  }

  @ParameterizedTest
  @EnumSource
  void rightHandSideThatIsNotFiniteAtTheStartIsNamed(OdeMethod method) {
    assertThatThrownBy(
            () ->
                Ode.solve(
                    (t, y, yDot) -> yDot[0] = Math.sqrt(y[0]),
                    0,
                    new double[] {-1},
                    1,
                    with(method)))
        .isInstanceOf(IntegrationException.class)
        .hasMessageContaining("ended at t = 0.0")
        .hasMessageContaining("not finite")
        .hasMessageContaining("y[0]");
  }

  // Wrong use

  @Test
  void badInputIsRefusedByNameAndValue() {
    double[] y0 = {1, 0};
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Ode.solve(ROTATION, Double.NaN, y0, 1))
        .withMessageContaining("start is NaN");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Ode.solve(ROTATION, 0, y0, Double.POSITIVE_INFINITY))
        .withMessageContaining("end is Infinity");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Ode.solve(ROTATION, 0, new double[] {1, Double.NaN}, 1))
        .withMessageContaining("component 1 is NaN");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Ode.solve(Ode.system(3, ROTATION), 0, y0, 1))
        .withMessageContaining("length of the initial state is 2")
        .withMessageContaining("3");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> OdeOptions.standard().rtol(0))
        .withMessageContaining("relative tolerance is 0.0");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> OdeOptions.standard().atol())
        .withMessageContaining("number of absolute tolerances is 0");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> OdeOptions.standard().atol(1e-6, -1))
        .withMessageContaining("absolute tolerance is -1.0");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> OdeOptions.standard().maxStep(0))
        .withMessageContaining("largest step is 0.0");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> OdeOptions.standard().maxSteps(0))
        .withMessageContaining("number of steps allowed is 0");
  }

  @Test
  void placesOutsideAndArraysOfOtherLengthAreRefused() {
    OdeSolution solution = Ode.solve(ROTATION, 0, new double[] {1, 0}, 1);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> solution.at(1.5))
        .withMessageContaining("t = 1.5")
        .withMessageContaining("from 0.0 to 1.0");
    assertThatIllegalArgumentException().isThrownBy(() -> solution.at(Double.NaN));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> solution.at(0.5, new double[3]))
        .withMessageContaining("length of y is 3")
        .withMessageContaining("2");
  }
}
