package org.mechservice.solver.ode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.suite.DetestA3;
import org.mechservice.solver.ode.suite.EulerRigidBody;
import org.mechservice.solver.ode.suite.ExactProblem;
import org.mechservice.solver.ode.suite.FastOscillator;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.Kepler;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.suite.SuiteProblem;

/** What every integrator of explicit problems does. */
public abstract class IntegratorContract extends FailureContract {
  // Accuracy

  @Test
  void errorIsProportionalToTolerance() {
    // Over five decades of tolerance the error falls by five decades, give or take one: the error
    // per step is held between a fraction of the tolerance and the tolerance.
    SuiteProblem problem = new EulerRigidBody();
    double loose = problem.reference().mixedDigits(end(problem, 1e-5), problem.reference().atEnd());
    double tight =
        problem.reference().mixedDigits(end(problem, 1e-10), problem.reference().atEnd());
    assertThat(tight - loose).isBetween(4.0, 6.0);
  }

  private double[] end(SuiteProblem problem, double tolerance) {
    return Run.of(create(Run.settings(problem, tolerance)), problem).atEnd();
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5})
  void stepsGrowWithTheRootOfTheToleranceThatTheOrderSays(int order) {
    assertStepsGrowWithTheRootOfTheTolerance(order);
  }

  final void assertStepsGrowWithTheRootOfTheTolerance(int order) {
    // Local error ~ h^(k+1): 1e4 times tighter means 10^(4/(k+1)) times the steps. The start and
    // the jumps of the step size by factors leave 25 %.
    double tolerance = toleranceOfOrders();
    long loose = Run.of(create(withMaxOrder(tolerance, order)), SMOOTH).statistics().steps();
    long tight = Run.of(create(withMaxOrder(1e-4 * tolerance, order)), SMOOTH).statistics().steps();
    double expected = StrictMath.pow(10, 4.0 / (order + 1));
    assertThat((double) tight / loose).isBetween(0.75 * expected, 1.25 * expected);
  }

  @Test
  void orderStaysBelowTheHighestAllowed() {
    Integrator integrator = create(withMaxOrder(1e-10, 4));
    integrator.start(SMOOTH, 0, new double[] {1}, 20);
    int highest = 0;
    while (integrator.step() == StepResult.ADVANCED) {
      highest = Math.max(highest, integrator.order());
    }
    assertThat(highest).isEqualTo(4);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-200, 1, 1e200})
  void unitsOfStateAndTimeDoNotMatter(double unit) {
    // A rotation by 10 rad; squares of such numbers are beyond the range of floating point.
    FunctionOde slow =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = y[1] / unit;
              yDot[1] = -y[0] / unit;
            });
    for (double size : new double[] {1, unit}) {
      IntegratorSettings settings = componentwise(1e-8 * size, 1e-8 * size);
      Run run = Run.of(create(settings), slow, 0, new double[] {size, 0}, 10 * unit);
      assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
      assertThat(run.atEnd()[0] / size).isCloseTo(StrictMath.cos(10), within(1e-5));
      assertThat(run.atEnd()[1] / size).isCloseTo(-StrictMath.sin(10), within(1e-5));
    }
  }

  @Test
  void eachComponentIsHeldToItsOwnAbsoluteTolerance() {
    // Two equal decaying oscillators, of which the second may err by 1: the first decides.
    FunctionOde two =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = -y[0] + StrictMath.sin(3 * t);
              yDot[1] = -y[1] + StrictMath.sin(3 * t);
            });
    Integrator tight = create(componentwise(1e-10, 1.0));
    Integrator tighter = create(componentwise(1e-10, 1e-10));
    Integrator loose = create(componentwise(1.0, 1.0));
    double[] y0 = {0, 0};
    long tightSteps = Run.of(tight, two, 0, y0, 10).statistics().steps();
    double tighterSteps = Run.of(tighter, two, 0, y0, 10).statistics().steps();
    // The Euclidean norm sees two equal components √2 larger: 0.5 % of the steps.
    assertThat((double) tightSteps).isCloseTo(tighterSteps, within(0.1 * tightSteps));
    assertThat(Run.of(loose, two, 0, y0, 10).statistics().steps()).isLessThan(tightSteps / 3);
  }

  // Dense output

  @Test
  void stepKeptGivesTheBitsOfTheInterpolantWhenTheIntegrationHasGoneOn() {
    Integrator integrator = create(1e-7);
    integrator.start(new Kepler(), 0, new Kepler().reference().initialState(), 10);
    List<Double> places = new ArrayList<>();
    List<double[]> interpolated = new ArrayList<>();
    List<double[]> kept = new ArrayList<>();
    List<StepPolynomial> polynomials = new ArrayList<>();
    assertThatIllegalStateException()
        .isThrownBy(() -> integrator.keepStep(new double[100], 0))
        .withMessageContaining("no step was taken");
    while (integrator.step() == StepResult.ADVANCED) {
      double place = integrator.time() - 0.3 * integrator.stepSize();
      double[] numbers = new double[integrator.keptLength() + 5];
      double[] y = new double[8];
      places.add(place);
      kept.add(numbers);
      polynomials.add(integrator.keepStep(numbers, 5));
      interpolated.add(interpolate(integrator, place, y));
    }
    for (int i = 0; i < kept.size(); i++) {
      double[] y = new double[4];
      double[] yDot = new double[4];
      polynomials.get(i).evaluate(kept.get(i), 5, places.get(i), y, yDot);
      assertThat(y).isEqualTo(Arrays.copyOf(interpolated.get(i), 4));
      assertThat(yDot).isEqualTo(Arrays.copyOfRange(interpolated.get(i), 4, 8));
    }
  }

  /** State and derivative in one array. */
  private static double[] interpolate(Integrator integrator, double t, double[] both) {
    double[] y = new double[4];
    double[] yDot = new double[4];
    integrator.interpolate(t, y, yDot);
    System.arraycopy(y, 0, both, 0, 4);
    System.arraycopy(yDot, 0, both, 4, 4);
    return both;
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-4, 1e-6, 1e-8, 1e-10})
  void insideTheStepsTheErrorIsAtMostTenTimesThatAtTheirEnds(double tolerance) {
    for (ExactProblem problem : List.of(new DetestA3(), new Kepler(), new FastOscillator())) {
      Integrator integrator = create(Run.settings(problem, tolerance));
      integrator.start(problem, 0, problem.reference().initialState(), problem.reference().end());
      double atEnds = tolerance;
      double inside = 0;
      while (integrator.step() == StepResult.ADVANCED) {
        atEnds = Math.max(atEnds, errorAt(integrator.time(), integrator, problem));
        for (double part : new double[] {0.01, 0.25, 0.5, 0.75, 0.99}) {
          double t = integrator.previousTime() + part * integrator.stepSize();
          inside = Math.max(inside, errorAt(t, integrator, problem));
        }
      }
      assertThat(inside).as(problem.name()).isLessThanOrEqualTo(10 * atEnds);
    }
  }

  private static double errorAt(double t, Integrator integrator, ExactProblem problem) {
    double[] y = Run.state(integrator, t, problem.dimension());
    return StrictMath.pow(10, -problem.reference().mixedDigits(y, problem.exact(t)));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-4, 1e-6, 1e-8})
  void checkpointsOfTheSuiteAreMetAsWellAsAStepEndThere(double tolerance) {
    assertCheckpointsAreMet(SuiteProblem.nonstiff(), tolerance);
  }

  protected final void assertCheckpointsAreMet(List<SuiteProblem> problems, double tolerance) {
    for (SuiteProblem problem : problems) {
      double t = problem.reference().checkpointTime();
      Integrator integrator = create(Run.settings(problem, tolerance));
      integrator.start(problem, 0, problem.reference().initialState(), problem.reference().end());
      do {
        assertThat(integrator.step()).isNotEqualTo(StepResult.FAILED);
      } while (integrator.time() < t);
      double[] dense = Run.state(integrator, t, problem.dimension());
      double[] ended =
          Run.of(
                  create(Run.settings(problem, tolerance)),
                  problem,
                  0,
                  problem.reference().initialState(),
                  t)
              .atEnd();
      // One digit, from an error no smaller than the tolerance: a step end may be right by luck.
      double endedDigits =
          Math.min(
              problem.reference().mixedDigits(ended, problem.reference().atCheckpoint()),
              -StrictMath.log10(tolerance));
      assertThat(problem.reference().mixedDigits(dense, problem.reference().atCheckpoint()))
          .as(problem.name())
          .isGreaterThanOrEqualTo(endedDigits - 1);
    }
  }

  @Test
  void interpolatedDerivativeIsTheSlopeOfTheInterpolatedState() {
    Integrator integrator = create(1e-6);
    integrator.start(SMOOTH, 0, new double[] {1}, 20);
    double[] yDot = new double[1];
    double[] before = new double[1];
    double[] after = new double[1];
    double[] unused = new double[1];
    for (int i = 0; i < 60; i++) {
      integrator.step();
      double t = integrator.previousTime() + 0.5 * integrator.stepSize();
      double d = 1e-4 * integrator.stepSize();
      integrator.interpolate(t - d, before, unused);
      integrator.interpolate(t + d, after, unused);
      integrator.interpolate(t, unused, yDot);
      // Central difference: d² y''' / 6 and round-off of y over d, both far below 1e-6.
      assertThat((after[0] - before[0]) / (2 * d)).isCloseTo(yDot[0], within(1e-6));
    }
  }

  @Test
  void interpolationMeetsTheStepEndExactlyAndItsBeginningWithinTheTolerance() {
    double tolerance = 1e-6;
    Integrator integrator = create(tolerance);
    integrator.start(SMOOTH, 0, new double[] {1}, 20);
    double last = 1;
    while (integrator.step() == StepResult.ADVANCED) {
      double begin = Run.state(integrator, integrator.previousTime(), 1)[0];
      // y is between 0.36 and 2.72: the tolerance of a step is at most 3.8e-6.
      assertThat(begin).isCloseTo(last, within(4 * tolerance));
      last = Run.state(integrator, integrator.time(), 1)[0];
    }
    assertThat(integrator.time()).isEqualTo(20);
  }

  @Test
  void interpolationLeavesTheRunAsItIs() {
    SuiteProblem problem = new Kepler();
    Integrator integrator = create(Run.settings(problem, 1e-8));
    integrator.start(problem, 0, problem.reference().initialState(), 20);
    StepResult result;
    do {
      result = integrator.step();
      double t = integrator.previousTime() + 0.3 * integrator.stepSize();
      double[] scribbled = Run.state(integrator, t, 4);
      Arrays.fill(scribbled, Double.NaN);
    } while (result == StepResult.ADVANCED);
    assertThat(Run.state(integrator, 20, 4))
        .isEqualTo(Run.of(create(Run.settings(problem, 1e-8)), problem).atEnd());
  }

  @Test
  void interpolationOutsideTheLastStepIsRefused() {
    Integrator integrator = create(1e-6);
    integrator.start(SMOOTH, 0, new double[] {1}, 20);
    integrator.step();
    double beyond = integrator.time() + 1;
    assertThatIllegalArgumentException()
        .isThrownBy(() -> integrator.interpolate(beyond, new double[1], new double[1]))
        .withMessageContaining(Double.toString(beyond));
  }

  // Direction, interval, step size

  @Test
  void stepsFollowEachOtherWithoutGap() {
    Integrator integrator = create(1e-6);
    integrator.start(SMOOTH, 0, new double[] {1}, 20);
    double last = 0;
    StepResult result;
    do {
      result = integrator.step();
      assertThat(integrator.previousTime()).isEqualTo(last);
      assertThat(integrator.time()).isGreaterThan(last);
      double distance = integrator.time() - last;
      double size = integrator.stepSize();
      if (result == StepResult.ADVANCED) {
        assertThat(size).isCloseTo(distance, within(4 * Math.ulp(integrator.time())));
      } else {
        // DE steps past the end.
        assertThat(size).isGreaterThan(distance - 4 * Math.ulp(integrator.time()));
      }
      last = integrator.time();
    } while (result == StepResult.ADVANCED);
    assertThat(last).isEqualTo(20);
  }

  @Test
  void backwardIntegrationReturnsToTheStart() {
    double[] forth = Run.of(create(1e-9), SMOOTH, 0, new double[] {1}, 20).atEnd();
    Run back = Run.of(create(1e-9), SMOOTH, 20, forth, 0);
    assertThat(back.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(back.integrator().stepSize()).isNegative();
    assertThat(back.atEnd()[0]).isCloseTo(1, within(accumulation() * 1e-9));
  }

  @Test
  void mirroredTimeTakesTheSameSteps() {
    FunctionOde mirrored = new FunctionOde(1, (t, y, yDot) -> yDot[0] = -y[0] * StrictMath.cos(-t));
    Run forth = Run.of(create(1e-8), SMOOTH, 0, new double[] {1}, 20);
    Run mirror = Run.of(create(1e-8), mirrored, 0, new double[] {1}, -20);
    assertThat(mirror.atEnd()).isEqualTo(forth.atEnd());
    assertThat(mirror.statistics()).isEqualTo(forth.statistics());
  }

  @Test
  void intervalOfLengthZeroIsAtItsEnd() {
    Run run = Run.of(create(1e-6), SMOOTH, 2, new double[] {5}, 2);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(run.atEnd()).containsExactly(5);
    assertThat(run.statistics().steps()).isZero();
    assertThatIllegalStateException().isThrownBy(() -> run.integrator().step());
  }

  @Test
  void firstStepOf1eMinus30FromZeroIsTakenAndOutgrown() {
    Integrator integrator = create(withFirstStep(1e-30));
    integrator.start(SMOOTH, 0, new double[] {1}, 20);
    integrator.step();
    assertThat(integrator.time()).isEqualTo(1e-30);
    Run run = Run.of(integrator, SMOOTH);
    // Doubling from 1e-30 to 1e-1 takes 97 steps; the order then grows from 1 again.
    assertThat(run.statistics().steps())
        .isLessThan(Run.of(create(1e-6), SMOOTH).statistics().steps() + 120);
    assertThat(run.atEnd()[0])
        .isCloseTo(SMOOTH.reference().atEnd()[0], within(accumulation() * 1e-6));
  }

  @Test
  void firstStepTooSmallForTheArithmeticIsRaised() {
    FunctionOde shifted =
        new FunctionOde(1, (t, y, yDot) -> yDot[0] = y[0] * StrictMath.cos(t - 1e6));
    Run run = Run.of(create(withFirstStep(1e-30)), shifted, 1e6, new double[] {1}, 1e6 + 20);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    // 1e6 holds its fraction to 1e-10, which shifts cos t by as much: invisible at 1e-4.
    assertThat(run.atEnd()[0])
        .isCloseTo(SMOOTH.reference().atEnd()[0], within(accumulation() * 1e-6));
  }

  @Test
  void firstStepGivenIsTried() {
    Integrator integrator = create(withFirstStep(1e-4));
    integrator.start(SMOOTH, 0, new double[] {1}, 20);
    integrator.step();
    assertThat(integrator.stepSize()).isEqualTo(1e-4);
  }

  @Test
  void noStepIsLongerThanAllowed() {
    Integrator integrator =
        create(
            new IntegratorSettings(1e-3, List.of(1e-3), 0.05, 0, 0, Long.MAX_VALUE, () -> false));
    integrator.start(SMOOTH, 0, new double[] {1}, 20);
    double longest = 0;
    while (integrator.step() == StepResult.ADVANCED) {
      longest = Math.max(longest, integrator.stepSize());
    }
    assertThat(longest).isEqualTo(0.05);
  }

  @Test
  void constantSolutionIsExactOverAnyInterval() {
    double[] y0 = {1, -2e-300, 3e300};
    Run run = Run.of(create(1e-6), CONSTANT, 0, y0, 1e300);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(run.atEnd()).isEqualTo(y0);
    assertThat(run.statistics().steps()).isLessThan(CONSTANT_STEPS);
  }

  @Test
  void linearSolutionIsExactToRoundOff() {
    FunctionOde linear = new FunctionOde(1, (t, y, yDot) -> yDot[0] = 3);
    Run run = Run.of(create(1e-6), linear, 0, new double[] {1}, 1e6);
    assertThat(run.atEnd()[0]).isCloseTo(3e6 + 1, within(1e-8));
    assertThat(run.statistics().rejectedSteps()).isZero();
  }

  @Test
  void solutionAtRestUntilAForceActsIsNotSteppedOver() {
    // At rest f vanishes and gives no scale; the force acts from 0.2 to 0.4 of the interval.
    Run run = Run.of(create(1e-6), PUSHED, 0, new double[] {0, 0}, 5);
    assertThat(run.atEnd()[0]).isCloseTo(PUSHED_POSITION, within(1e-4));
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 4, 5, 6, 7, 8, 9})
  void jumpsOfTheRightHandSideAreCrossedWithinTwoDigits(int digits) {
    double tolerance = StrictMath.pow(10, -digits);
    Run run = Run.of(create(tolerance), PUSHED, 0, new double[] {0, 0}, 5);
    double error = Math.abs(run.atEnd()[0] - PUSHED_POSITION) / (1 + PUSHED_POSITION);
    assertThat(-StrictMath.log10(error)).isGreaterThanOrEqualTo(digits - 2);
  }
}
