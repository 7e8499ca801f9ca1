package org.mechservice.solver.integration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.integration.suite.DetestA3;
import org.mechservice.solver.integration.suite.EulerRigidBody;
import org.mechservice.solver.integration.suite.ExactProblem;
import org.mechservice.solver.integration.suite.FastOscillator;
import org.mechservice.solver.integration.suite.Kepler;
import org.mechservice.solver.integration.suite.SuiteProblem;
import org.mechservice.solver.integration.suite.VanDerPol;

/** What every integrator of explicit problems does. */
abstract class IntegratorContract {
  private static final double UNBOUNDED = Double.POSITIVE_INFINITY;

  /** y' = y cos t, solution exp(sin t) from 1 at t = 0. */
  private static final ExactProblem SMOOTH = new DetestA3();

  private static final Ode CONSTANT = new Ode(3, (t, y, yDot) -> Arrays.fill(yDot, 0));

  /** An oscillator at rest on which a force acts from t = 1 to t = 2 (suite: step_force). */
  private static final Ode PUSHED =
      new Ode(
          2,
          (t, y, yDot) -> {
            yDot[0] = y[1];
            yDot[1] = (t >= 1 && t < 2 ? 50 : 0) - 0.4 * y[1] - 100 * y[0];
          });

  /** Its position at t = 5, in closed form. */
  private static final double PUSHED_POSITION = 0.18039197239119287;

  /** Steps allowed for a constant solution, whatever the interval. */
  private static final int CONSTANT_STEPS = 400;

  abstract Integrator create(IntegratorSettings settings);

  /** Returns how many tolerances the error of y' = y cos t may have become at t = 20. */
  abstract double accumulation();

  /** Returns the tolerance from which on a given order is used on smooth problems. */
  double toleranceOfOrders() {
    return 1e-4;
  }

  /** Returns by how much a step shrinks in which something was not finite. */
  abstract double notFiniteReduction();

  final Integrator create(double tolerance) {
    return create(new IntegratorSettings(tolerance, tolerance));
  }

  static IntegratorSettings withFirstStep(double initialStep) {
    return new IntegratorSettings(
        1e-6, List.of(1e-6), UNBOUNDED, initialStep, 0, Long.MAX_VALUE, () -> false);
  }

  static IntegratorSettings withMaxOrder(double tolerance, int maxOrder) {
    return new IntegratorSettings(
        tolerance, List.of(tolerance), UNBOUNDED, 0, maxOrder, Long.MAX_VALUE, () -> false);
  }

  private static IntegratorSettings withStop(BooleanSupplier stop) {
    return new IntegratorSettings(1e-6, List.of(1e-6), UNBOUNDED, 0, 0, Long.MAX_VALUE, stop);
  }

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

  @Test
  void eachComponentIsHeldToItsOwnAbsoluteTolerance() {
    // Two equal decaying oscillators, of which the second may err by 1: the first decides.
    Ode two =
        new Ode(
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

  private static IntegratorSettings componentwise(double... absoluteTolerance) {
    List<Double> tolerances = Arrays.stream(absoluteTolerance).boxed().toList();
    return new IntegratorSettings(1e-10, tolerances, UNBOUNDED, 0, 0, Long.MAX_VALUE, () -> false);
  }

  // Dense output

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

  final void assertCheckpointsAreMet(List<SuiteProblem> problems, double tolerance) {
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
      assertThat(integrator.stepSize())
          .isCloseTo(integrator.time() - last, within(4 * Math.ulp(integrator.time())));
      last = integrator.time();
    } while (result == StepResult.ADVANCED);
    assertThat(last).isGreaterThanOrEqualTo(20);
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
    Ode mirrored = new Ode(1, (t, y, yDot) -> yDot[0] = -y[0] * StrictMath.cos(-t));
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
    Ode shifted = new Ode(1, (t, y, yDot) -> yDot[0] = y[0] * StrictMath.cos(t - 1e6));
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
    Ode linear = new Ode(1, (t, y, yDot) -> yDot[0] = 3);
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

  // Values that are not finite

  @Test
  void rightHandSideNotFiniteAtTheStartFailsNamingTheComponent() {
    Ode broken =
        new Ode(
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
    Ode broken =
        new Ode(
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
    Ode guarded =
        new Ode(
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
    Ode broken =
        new Ode(
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
      assertThat(tries.get(i).attempt()).isEqualTo(Attempt.NOT_FINITE);
      assertThat(tries.get(i).error()).isNaN();
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {5, 6, 40, 41})
  void onePointThatIsNotFiniteIsSteppedAround(int evaluation) {
    // Odd and even: the evaluation at a prediction and at a corrected state.
    AtomicInteger count = new AtomicInteger();
    Ode blinking =
        new Ode(
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
    Ode root = new Ode(1, (t, y, yDot) -> yDot[0] = -Math.sqrt(y[0]));
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
    Ode blowUp = new Ode(1, (t, y, yDot) -> yDot[0] = y[0] * y[0]);
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

  // Limits and interruption

  @Test
  void numberOfStepsAllowedEndsTheRun() {
    Integrator integrator =
        create(new IntegratorSettings(1e-6, List.of(1e-6), UNBOUNDED, 0, 0, 30, () -> false));
    Run run = Run.of(integrator, SMOOTH);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    assertThat(integrator.failure().cause()).isEqualTo(IntegrationFailure.Cause.TOO_MANY_STEPS);
    assertThat(run.statistics().steps() + run.statistics().rejectedSteps()).isEqualTo(30);
    assertThatIllegalStateException().isThrownBy(integrator::step);
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 3, 50, 51, 52, 53, 200})
  void stopSignalEndsTheStepBeforeTheNextEvaluationAndLeavesTheState(int evaluation) {
    AtomicInteger evaluations = new AtomicInteger();
    Ode counted =
        new Ode(
            1,
            (t, y, yDot) -> {
              evaluations.incrementAndGet();
              yDot[0] = y[0] * StrictMath.cos(t);
            });
    Integrator integrator = create(withStop(() -> evaluations.get() >= evaluation));
    integrator.start(counted, 0, new double[] {1}, 20);
    double[] state = {1};
    StepResult result;
    while ((result = integrator.step()) == StepResult.ADVANCED) {
      state = Run.state(integrator, integrator.time(), 1);
    }
    assertThat(result).isEqualTo(StepResult.STOPPED);
    assertThat(evaluations.get()).isEqualTo(evaluation);
    assertThat(Run.state(integrator, integrator.time(), 1)).isEqualTo(state);
  }

  @Test
  void runStoppedAndTakenUpAgainHasTheSameBits() {
    AtomicInteger asked = new AtomicInteger();
    Integrator integrator =
        create(
            new IntegratorSettings(
                1e-6,
                List.of(1e-6),
                UNBOUNDED,
                0,
                0,
                Long.MAX_VALUE,
                () -> asked.incrementAndGet() % 7 == 0));
    SuiteProblem problem = new VanDerPol();
    integrator.start(problem, 0, problem.reference().initialState(), 20);
    List<Double> times = new ArrayList<>();
    StepResult result;
    do {
      result = integrator.step();
      if (result == StepResult.ADVANCED) {
        times.add(integrator.time());
      }
    } while (result != StepResult.REACHED_END);
    assertThat(times).isEqualTo(stepEnds(create(1e-6), problem));
    assertThat(Run.state(integrator, 20, 2)).isEqualTo(Run.of(create(1e-6), problem).atEnd());
  }

  private static List<Double> stepEnds(Integrator integrator, SuiteProblem problem) {
    List<Double> times = new ArrayList<>();
    integrator.start(problem, 0, problem.reference().initialState(), problem.reference().end());
    while (integrator.step() == StepResult.ADVANCED) {
      times.add(integrator.time());
    }
    return times;
  }

  @Test
  void integratorUsedAgainGivesTheSameBits() {
    Integrator used = create(1e-6);
    Run.of(used, new Kepler());
    assertThat(Run.of(used, SMOOTH).atEnd()).isEqualTo(Run.of(create(1e-6), SMOOTH).atEnd());
    assertThat(used.statistics()).isEqualTo(Run.of(create(1e-6), SMOOTH).statistics());
  }

  @Test
  void statisticsCountEveryEvaluation() {
    AtomicInteger evaluations = new AtomicInteger();
    Ode counted =
        new Ode(
            1,
            (t, y, yDot) -> {
              evaluations.incrementAndGet();
              yDot[0] = y[0] * StrictMath.cos(t);
            });
    Run run = Run.of(create(1e-6), counted, 0, new double[] {1}, 20);
    assertThat(run.statistics().evaluations()).isEqualTo(evaluations.get());
  }

  // What is given is left alone

  @Test
  void stateGivenAtTheStartIsNotModified() {
    double[] y0 = {0.1, 0, 0, Math.sqrt(19)};
    double[] copy = y0.clone();
    Run.of(create(1e-6), new Kepler(), 0, y0, 20);
    assertThat(y0).isEqualTo(copy);
  }

  @Test
  void stateGivenToTheRightHandSideKeepsItsValuesWhileTheDerivativeIsWritten() {
    Ode watching =
        new Ode(
            2,
            (t, y, yDot) -> {
              double y0 = y[0];
              double y1 = y[1];
              yDot[0] = y1;
              yDot[1] = (1 - y0 * y0) * y1 - y0;
              assertThat(y).containsExactly(y0, y1);
            });
    Run run = Run.of(create(1e-6), watching, 0, new double[] {2, 0}, 20);
    assertThat(run.atEnd()).isEqualTo(Run.of(create(1e-6), new VanDerPol()).atEnd());
  }

  @Test
  void stepsAndInterpolationAllocateNothing() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    Integrator integrator = create(1e-8);
    SuiteProblem problem = new Kepler();
    double[] y = new double[4];
    double[] yDot = new double[4];
    long steps = 0;
    long allocated = 0;
    // The first runs load classes; the last one is measured.
    for (int run = 0; run < 20; run++) {
      integrator.start(problem, 0, problem.reference().initialState(), 20);
      steps = 0;
      long before = threads.getCurrentThreadAllocatedBytes();
      while (integrator.step() == StepResult.ADVANCED) {
        integrator.interpolate(integrator.time() - 0.5 * integrator.stepSize(), y, yDot);
        steps++;
      }
      allocated = threads.getCurrentThreadAllocatedBytes() - before;
    }
    assertThat(integrator.statistics().rejectedSteps()).isPositive();
    assertThat(steps).isGreaterThan(200);
    assertThat(allocated).isZero();
  }

  // Wrong use

  @ParameterizedTest
  @ValueSource(doubles = {2.2e-14, 0, -1e-6, 1, Double.NaN})
  void relativeToleranceOutOfRangeIsRefusedWithValueAndFloor(double tolerance) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> create(new IntegratorSettings(tolerance, 1e-6)))
        .withMessageContaining("relative tolerance is " + tolerance)
        .withMessageContaining("2.3E-14");
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -1e-6, Double.NaN, Double.POSITIVE_INFINITY})
  void absoluteToleranceThatIsNotPositiveIsRefused(double tolerance) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> create(new IntegratorSettings(1e-6, tolerance)))
        .withMessageContaining("absolute tolerance is " + tolerance);
  }

  @Test
  void absoluteTolerancesOfTheWrongNumberAreRefused() {
    Integrator integrator = create(componentwise(1e-6, 1e-6));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> integrator.start(new EulerRigidBody(), 0, new double[3], 1))
        .withMessageContaining("number of absolute tolerances is 2")
        .withMessageContaining("3");
  }

  @Test
  void orderOutOfRangeIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> create(withMaxOrder(1e-6, 14)))
        .withMessageContaining("highest order is 14");
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void endThatIsNotFiniteIsRefused(double end) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> create(1e-6).start(SMOOTH, 0, new double[] {1}, end))
        .withMessageContaining("end is " + end);
  }

  @Test
  void initialStateOfTheWrongLengthIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> create(1e-6).start(SMOOTH, 0, new double[2], 1))
        .withMessageContaining("length of the initial state is 2; it must be 1");
  }

  @Test
  void initialStateThatIsNotFiniteIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> create(1e-6).start(SMOOTH, 0, new double[] {Double.NaN}, 1))
        .withMessageContaining("component 0 is NaN");
  }

  @Test
  void stepBeforeTheStartIsRefused() {
    assertThatIllegalStateException().isThrownBy(() -> create(1e-6).step());
  }

  @Test
  void failureIsToldOnlyAfterOne() {
    assertThatIllegalStateException()
        .isThrownBy(() -> Run.of(create(1e-6), SMOOTH).integrator().failure());
  }
}
