package org.mechservice.solver.ode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

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
import org.mechservice.solver.ode.suite.DetestA3;
import org.mechservice.solver.ode.suite.EulerRigidBody;
import org.mechservice.solver.ode.suite.ExactProblem;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.Kepler;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.suite.SuiteProblem;
import org.mechservice.solver.ode.suite.VanDerPol;

/** How an integrator is used: limits, interruption, what is handed in, and what is refused. */
public abstract class UsageContract {
  static final double UNBOUNDED = Double.POSITIVE_INFINITY;

  /** y' = y cos t, solution exp(sin t) from 1 at t = 0. */
  static final ExactProblem SMOOTH = new DetestA3();

  static final FunctionOde CONSTANT = new FunctionOde(3, (t, y, yDot) -> Arrays.fill(yDot, 0));

  /** An oscillator at rest on which a force acts from t = 1 to t = 2 (suite: step_force). */
  static final FunctionOde PUSHED =
      new FunctionOde(
          2,
          (t, y, yDot) -> {
            yDot[0] = y[1];
            yDot[1] = (t >= 1 && t < 2 ? 50 : 0) - 0.4 * y[1] - 100 * y[0];
          });

  /** Its position at t = 5, in closed form. */
  static final double PUSHED_POSITION = 0.18039197239119287;

  /** Steps allowed for a constant solution, whatever the interval. */
  static final int CONSTANT_STEPS = 400;

  protected abstract Integrator create(IntegratorSettings settings);

  /** Returns how many tolerances the error of y' = y cos t may have become at t = 20. */
  protected abstract double accumulation();

  /** Returns the tolerance from which on a given order is used on smooth problems. */
  protected double toleranceOfOrders() {
    return 1e-4;
  }

  /** Returns by how much a step shrinks in which something was not finite. */
  protected abstract double notFiniteReduction();

  protected final Integrator create(double tolerance) {
    return create(new IntegratorSettings(tolerance, tolerance));
  }

  protected static IntegratorSettings withFirstStep(double initialStep) {
    return new IntegratorSettings(
        1e-6, List.of(1e-6), UNBOUNDED, initialStep, 0, Long.MAX_VALUE, () -> false);
  }

  protected static IntegratorSettings withMaxOrder(double tolerance, int maxOrder) {
    return new IntegratorSettings(
        tolerance, List.of(tolerance), UNBOUNDED, 0, maxOrder, Long.MAX_VALUE, () -> false);
  }

  protected static IntegratorSettings withStop(BooleanSupplier stop) {
    return new IntegratorSettings(1e-6, List.of(1e-6), UNBOUNDED, 0, 0, Long.MAX_VALUE, stop);
  }

  protected static IntegratorSettings componentwise(double... absoluteTolerance) {
    List<Double> tolerances = Arrays.stream(absoluteTolerance).boxed().toList();
    return new IntegratorSettings(1e-10, tolerances, UNBOUNDED, 0, 0, Long.MAX_VALUE, () -> false);
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
    FunctionOde counted =
        new FunctionOde(
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

  protected static List<Double> stepEnds(Integrator integrator, SuiteProblem problem) {
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
    FunctionOde counted =
        new FunctionOde(
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
    FunctionOde watching =
        new FunctionOde(
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
    long allocated = Long.MAX_VALUE;
    // All runs are the same. The first load classes; in a later one the virtual machine may make an
    // object of its own when it takes compiled code back.
    for (int run = 0; run < 20; run++) {
      integrator.start(problem, 0, problem.reference().initialState(), 20);
      steps = 0;
      long before = threads.getCurrentThreadAllocatedBytes();
      while (integrator.step() == StepResult.ADVANCED) {
        integrator.interpolate(integrator.time() - 0.5 * integrator.stepSize(), y, yDot);
        steps++;
      }
      allocated = Math.min(allocated, threads.getCurrentThreadAllocatedBytes() - before);
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
