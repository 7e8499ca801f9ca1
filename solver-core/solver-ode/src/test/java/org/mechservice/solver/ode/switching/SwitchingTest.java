package org.mechservice.solver.ode.switching;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.Integrator.MethodChange;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.jumps.UndeclaredJumps;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.suite.Flame;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.suite.StiffVanDerPol;
import org.mechservice.solver.ode.suite.SuiteProblem;

/** The method changes where stiffness comes and goes, and nowhere else. */
class SwitchingTest {
  /** Periods of 1615: slow, stiff stretches with two jumps each, which are not stiff. */
  private static final FunctionOde RELAXATION =
      new FunctionOde(
          2,
          (t, y, yDot) -> {
            yDot[0] = y[1];
            yDot[1] = 1000 * (1 - y[0] * y[0]) * y[1] - y[0];
          });

  /** Decays to a slow cosine, fast, from t = 10 on slowly: stiff on [0, 10] alone. */
  private static final FunctionOde STIFF_AT_FIRST =
      new FunctionOde(
          1,
          (t, y, yDot) ->
              yDot[0] = -(t < 10 ? 1e4 : 1) * (y[0] - StrictMath.cos(t)) - StrictMath.sin(t));

  private static Run relaxation(double tolerance, double periods) {
    IntegratorSettings settings = new IntegratorSettings(tolerance, tolerance);
    return Run.of(new Switching(settings), RELAXATION, 0, new double[] {2, 0}, 1615 * periods);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-5, 1e-6, 1e-9})
  void relaxationOscillatorChangesMethodAtEveryJumpAndBack(double tolerance) {
    // Ten periods have twenty jumps: one change before the first, two at each.
    Run run = relaxation(tolerance, 10);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(run.integrator().methodChangeCount()).isBetween(35L, 46L);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-4, 3e-5, 1e-5, 1e-6, 1e-8})
  void relaxationOscillatorCostsNoMoreThanTheStiffMethodAlone(double tolerance) {
    // A phase of few steps may have paid all the same: it covers what ode113 could not.
    IntegratorSettings settings = new IntegratorSettings(tolerance, tolerance);
    Run stiff = Run.of(new Ode15s(settings), RELAXATION, 0, new double[] {2, 0}, 16_150);
    assertThat(relaxation(tolerance, 10).statistics().evaluations())
        .isLessThan(stiff.statistics().evaluations());
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
        Run.of(
            UndeclaredJumps.around(new Switching(new IntegratorSettings(1e-8, 1e-8))),
            dry,
            0,
            new double[] {3.3, 0},
            20);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    assertThat(run.integrator().failure().cause())
        .isEqualTo(IntegrationFailure.Cause.STEP_TOO_SMALL);
    assertThat(run.integrator().time()).isCloseTo(2 * Math.PI, within(1e-3));
    assertThat(run.atEnd()).containsExactly(new double[] {-0.7, 0}, within(1e-4));
    assertThat(run.statistics().evaluations()).isLessThan(100_000);
  }

  /**
   * Rounding changes the last digits of f between prediction and correction, which differ by less
   * than f moves: in the short first steps that is h L of 2 to 300 for a pendulum with h L below
   * 0.001.
   */
  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-6, 1e-9})
  void roundingInTheFirstStepsDoesNotLookLikeStiffness(double tolerance) {
    for (double rounding : new double[] {1e-15, 1e-13, 1e-11}) {
      for (int i = 0; i < 60; i++) {
        double stiffness = 1 + 0.01 * i;
        FunctionOde pendulum =
            new FunctionOde(
                2,
                (t, y, yDot) -> {
                  yDot[0] = y[1];
                  double exact = -stiffness * StrictMath.sin(y[0]);
                  yDot[1] = exact * (1 + rounding * lastDigits(y[1]));
                });
        Switching run = new Switching(new IntegratorSettings(tolerance, 1e-3 * tolerance));
        StepResult result = run.start(pendulum, 0, new double[] {1 + 0.013 * i, 0}, 100);
        for (int step = 0; step < 20 && result == StepResult.ADVANCED; step++) {
          result = run.step();
        }
        assertThat(result).isEqualTo(StepResult.ADVANCED);
        assertThat(run.methodChangeCount()).isZero();
      }
    }
  }

  /** Returns a number from −1 to 1 that differs at random between neighbouring values. */
  private static double lastDigits(double value) {
    long mixed = Double.doubleToLongBits(value) * 0x9E3779B97F4A7C15L;
    return (mixed >> 11) * 0x1p-52;
  }

  @Test
  void slidingAlongWhatIsOnlySteepIsLeftToTheStiffMethod() {
    FunctionOde steep =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = y[1];
              yDot[1] = 1000 * (0.01 * t - y[0]) - 5 * y[1] / Math.hypot(y[1], 1e-9);
            });
    Run run =
        Run.of(
            new Switching(new IntegratorSettings(1e-8, 1e-8)), steep, 0, new double[] {0, 0}, 0.4);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(run.integrator().methodChangeCount()).isEqualTo(1);
    // It creeps at a part of 1e-9 m/s: the spring's 4 N at the end are less than friction.
    assertThat(run.atEnd()).containsExactly(new double[] {0, 0}, within(1e-8));
    assertThat(run.statistics().evaluations()).isLessThan(100_000);
  }

  @Test
  void changesAreToldInOrderWithTheirReason() {
    List<MethodChange> changes = relaxation(1e-6, 2).integrator().methodChanges();
    assertThat(changes).hasSizeGreaterThan(3);
    for (int i = 0; i < changes.size(); i++) {
      assertThat(changes.get(i).stiff()).isEqualTo(i % 2 == 0);
      assertThat(i == 0 || changes.get(i).time() > changes.get(i - 1).time()).isTrue();
      assertThat(changes.get(i).stepSize()).isPositive();
    }
  }

  @Test
  void onlyTheFirstChangesAreRemembered() {
    Run run = relaxation(1e-4, 20);
    assertThat(run.integrator().methodChangeCount()).isGreaterThan(40);
    assertThat(run.integrator().methodChanges()).hasSize(16);
  }

  /**
   * The error tests of ode113 take each crossing of the law's slope for a jump, at some of these.
   */
  @ParameterizedTest
  @ValueSource(doubles = {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9})
  void steepLawThatIsCrossedAgainAndAgainIsLeftToTheStiffMethod(double tolerance) {
    // 5 N of friction hold a block that 3 N push: it creeps at 0.75e-6 m/s.
    FunctionOde held =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = y[1];
              yDot[1] = 3 - 5 * y[1] / Math.hypot(y[1], 1e-6);
            });
    IntegratorSettings settings = new IntegratorSettings(tolerance, 0.01 * tolerance);
    Run run = Run.of(new Switching(settings), held, 0, new double[] {0, 0}, 2);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(run.integrator().methodChangeCount()).isEqualTo(1);
    assertThat(run.statistics().evaluations()).isLessThan(1000);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-5, 1e-8, 1e-11})
  void problemThatIsNotStiffIsIntegratedByOde113ToTheBit(double tolerance) {
    for (SuiteProblem problem : SuiteProblem.nonstiff()) {
      IntegratorSettings settings = Run.settings(problem, tolerance);
      Run alone = Run.of(new Ode113(settings), problem);
      Run switching = Run.of(new Switching(settings), problem);
      assertThat(switching.atEnd()).as(problem.name()).isEqualTo(alone.atEnd());
      assertThat(switching.statistics()).as(problem.name()).isEqualTo(alone.statistics());
      assertThat(switching.integrator().methodChanges()).as(problem.name()).isEmpty();
    }
  }

  /**
   * Evaluations, and what steps take beside them: on the Brusselator of 40 unknowns a step of
   * ode15s takes 3.6 times the processor time of one of ode113 and two thirds of its evaluations.
   */
  @Test
  void stiffProblemCostsHardlyMoreThanWithOde15s() {
    // Finding out takes some 30 steps; only runs of hardly more than that feel it.
    for (SuiteProblem problem : SuiteProblem.stiff()) {
      for (int k = 3; k <= 9; k++) {
        IntegratorSettings settings = Run.settings(problem, StrictMath.pow(10, -k));
        StepCosts costs = StepCosts.of(problem);
        double stiff = cost(new Ode15s(settings), problem, costs);
        assertThat(cost(new Switching(settings), problem, costs))
            .as("%s, 1e-%d", problem.name(), k)
            .isLessThanOrEqualTo(Math.max(1.3 * stiff, 50 * costs.adamsStep() + stiff));
      }
    }
  }

  private static double cost(Integrator integrator, SuiteProblem problem, StepCosts costs) {
    double[] y0 = problem.reference().initialState();
    StepResult result = integrator.start(problem, 0, y0, problem.reference().end());
    boolean switching = integrator instanceof Switching;
    long ofAdams = 0;
    long ofBackward = 0;
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
      if (switching && integrator.methodChangeCount() % 2 == 0) {
        ofAdams++;
      } else {
        ofBackward++;
      }
    }
    assertThat(result).isEqualTo(StepResult.REACHED_END);
    IntegrationStatistics done = integrator.statistics();
    double adamsStep = costs.adamsStep() - costs.backward(0, 2, 0);
    return ofAdams * adamsStep
        + costs.backward(ofBackward, done.evaluations(), done.factorisations());
  }

  private static final FunctionOde VIBRATING =
      new FunctionOde(
          2,
          (t, y, yDot) -> {
            yDot[0] = -1000 * (y[0] - y[1]);
            yDot[1] = 150 * StrictMath.cos(150 * t);
          });

  /**
   * Its decay keeps the steps of ode113 at 0.7 ms and its oscillation those of order 5 below that,
   * though not those of order 12.
   */
  @Test
  void stabilityThatLimitsStepsWhichImplicitOnesWouldNotExceedIsNoReasonToChange() {
    for (double tolerance : new double[] {1e-7, 1e-8}) {
      IntegratorSettings settings = new IntegratorSettings(tolerance, tolerance);
      Ode113 alone = new Ode113(settings);
      Run.of(alone, VIBRATING, 0, new double[] {0, 0}, 2);
      assertThat(alone.statistics().stiffnessSuspected()).isTrue();
      Switching integrator = new Switching(settings);
      Run.of(integrator, VIBRATING, 0, new double[] {0, 0}, 2);
      assertThat(integrator.methodChanges()).as("%g", tolerance).isEmpty();
    }
  }

  /** Steps as long as those of ode113 with one evaluation each take half as many. */
  @Test
  void implicitStepsThatAreNoShorterAreReasonToChangeForTheirEvaluations() {
    IntegratorSettings settings = new IntegratorSettings(1e-6, 1e-6);
    double[] y0 = {0, 0};
    double explicit = Run.of(new Ode113(settings), VIBRATING, 0, y0, 2).statistics().evaluations();
    double stiff = Run.of(new Ode15s(settings), VIBRATING, 0, y0, 2).statistics().evaluations();
    assertThat(explicit).isGreaterThan(1.8 * stiff);
    assertThat(Run.of(new Switching(settings), VIBRATING, 0, y0, 2).statistics().evaluations())
        .isLessThan((long) (1.1 * stiff));
  }

  @Test
  void stiffnessThatBeginsShortlyBeforeTheEndIsNotWorthAChange() {
    FunctionOde gripped =
        new FunctionOde(
            1,
            (t, y, yDot) ->
                yDot[0] = -(t < 10 ? 1 : 1e4) * (y[0] - StrictMath.cos(t)) - StrictMath.sin(t));
    // From t = 10 on ode113 needs 7 steps for each 0.001, and ode15s 15 to begin.
    IntegratorSettings settings = new IntegratorSettings(1e-6, 1e-6);
    Switching soon = new Switching(settings);
    Run.of(soon, gripped, 0, new double[] {1000}, 10.002);
    assertThat(soon.methodChanges()).isEmpty();
    for (double end : new double[] {10.005, 10.01, 10.1}) {
      Switching worth = new Switching(settings);
      Run.of(worth, gripped, 0, new double[] {1000}, end);
      assertThat(worth.methodChanges()).hasSize(1);
      Run explicit = Run.of(new Ode113(settings), gripped, 0, new double[] {1000}, end);
      assertThat(worth.statistics().evaluations()).isLessThan(explicit.statistics().evaluations());
    }
  }

  @Test
  void methodsAboutEquallyGoodDoNotTakeTurns() {
    // Rates of 1 and 30: at these tolerances both methods cost the same within a factor of two.
    FunctionOde moderate =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = -30 * (y[0] - y[1]);
              yDot[1] = -y[1] + StrictMath.cos(t);
            });
    for (int k = 3; k <= 10; k++) {
      double tolerance = StrictMath.pow(10, -k);
      Switching integrator = new Switching(new IntegratorSettings(tolerance, tolerance));
      Run.of(integrator, moderate, 0, new double[] {1, 0}, 300);
      assertThat(integrator.methodChangeCount()).as("1e-%d", k).isLessThanOrEqualTo(8);
    }
  }

  @Test
  void stiffnessThatEndsAtADeclaredJumpIsLeftBehind() {
    IntegratorSettings settings = new IntegratorSettings(1e-9, 1e-9);
    Switching integrator = new Switching(settings);
    Run run = Run.of(integrator, STIFF_AT_FIRST, 0, new double[] {1}, 60);
    assertThat(run.atEnd()[0]).isCloseTo(StrictMath.cos(60), within(1e-7));
    assertThat(integrator.methodChanges()).hasSize(2);
    assertThat(integrator.methodChanges().get(1).time()).isGreaterThan(10);
  }

  @Test
  void lastStepCanBeInterpolatedUntilTheNextMethodHasTakenOver() {
    Switching integrator = new Switching(new IntegratorSettings(1e-6, 1e-6));
    StepResult result = integrator.start(RELAXATION, 0, new double[] {2, 0}, 1000);
    double[] y = new double[2];
    double[] before = new double[2];
    double[] yDot = new double[2];
    while (result == StepResult.ADVANCED) {
      integrator.interpolate(integrator.time(), before, yDot);
      double end = integrator.time();
      result = integrator.step();
      assertThat(integrator.previousTime()).isEqualTo(end);
      integrator.interpolate(end, y, yDot);
      assertThat(y[0]).isCloseTo(before[0], within(1e-5));
    }
    assertThat(integrator.methodChangeCount()).isPositive();
  }

  @ParameterizedTest
  @EnumSource(Mode.class)
  void everyModeChangesMethod(Mode mode) {
    SuiteProblem problem = new Flame();
    Run run = Run.of(new Switching(Run.settings(problem, 1e-6).withMode(mode)), problem);
    assertThat(run.integrator().methodChangeCount()).isPositive();
    assertThat(problem.reference().mixedDigits(run.atEnd(), problem.reference().atEnd()))
        .isGreaterThan(5);
  }

  @Test
  void integrationTakenUpBetweenAnyStepsGoesOnWithTheSameBits() {
    SuiteProblem problem = new StiffVanDerPol();
    IntegratorSettings settings = Run.settings(problem, 1e-4);
    Integrator whole = new Switching(settings);
    Integrator cut = new Switching(settings);
    double[] y0 = problem.reference().initialState();
    StepResult result = whole.start(problem, 0, y0, 2000);
    cut.start(problem, 0, y0, 2000);
    while (result == StepResult.ADVANCED) {
      byte[] saved = cut.save();
      cut = new Switching(settings);
      assertThat(cut.resume(new StiffVanDerPol(), saved)).isEqualTo(StepResult.ADVANCED);
      result = whole.step();
      assertThat(cut.step()).isEqualTo(result);
      assertThat(cut.time()).isEqualTo(whole.time());
      assertThat(cut.order()).isEqualTo(whole.order());
    }
    assertThat(whole.methodChangeCount()).isGreaterThan(4);
    assertThat(cut.methodChanges()).isEqualTo(whole.methodChanges());
    assertThat(cut.statistics()).isEqualTo(whole.statistics());
    assertThat(Run.state(cut, 2000, 2)).isEqualTo(Run.state(whole, 2000, 2));
  }

  @Test
  void stepsAllowedAreThoseOfBothTogether() {
    IntegratorSettings bounded =
        new IntegratorSettings(
            1e-6, List.of(1e-6), Double.POSITIVE_INFINITY, 0, 0, 500, () -> false);
    Switching integrator = new Switching(bounded);
    Run run = Run.of(integrator, RELAXATION, 0, new double[] {2, 0}, 16_150);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    assertThat(integrator.methodChangeCount()).isGreaterThan(1);
    IntegrationStatistics done = integrator.statistics();
    assertThat(done.steps() + done.rejectedSteps()).isEqualTo(500);
    assertThat(integrator.failure().cause()).isEqualTo(IntegrationFailure.Cause.TOO_MANY_STEPS);
    assertThat(integrator.failure().lastSteps()).hasSize(10);
  }

  @Test
  void stateIsTheSameBeforeAndAfterAChange() {
    Switching integrator = new Switching(new IntegratorSettings(1e-5, 1e-5));
    StepResult result = integrator.start(RELAXATION, 0, new double[] {2, 0}, 1000);
    List<Double> ends = new ArrayList<>();
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
      ends.add(integrator.time());
    }
    assertThat(ends).isSorted().doesNotHaveDuplicates();
    for (MethodChange change : integrator.methodChanges()) {
      assertThat(ends).contains(change.time());
    }
  }

  /**
   * A rotation at 1e5 that hardly decays, about a slow circle. The first steps of ode113, accurate
   * but far too long for stability, stirred it up to some tolerances; then both methods had to
   * follow it: of 20 runs that start on the circle six took 40 000 steps, of 23 evaluations.
   */
  @Test
  void fastOscillationThatIsNotThereIsNotStirredUp() {
    compareOnCircle(20, 5);
  }

  @Tag("soak")
  @Test
  void fastOscillationThatIsNotThereIsNotStirredUpInTheLongRun() {
    compareOnCircle(1000, 6);
  }

  private static void compareOnCircle(int runs, long seed) {
    Random random = new Random(seed);
    int close = 0;
    for (int i = 0; i < runs; i++) {
      double decay = StrictMath.pow(10, 5 * random.nextDouble());
      double tolerance = StrictMath.pow(10, -3 - 5 * random.nextDouble());
      double slow = StrictMath.pow(10, random.nextDouble());
      double tEnd = 0.1 + 2 * random.nextDouble();
      FunctionOde rotation = rotation(1e5, decay, slow);
      IntegratorSettings settings = new IntegratorSettings(tolerance, tolerance);
      double[] start = {1, 0};
      long stiff =
          Run.of(new Ode15s(settings), rotation, 0, start, tEnd).statistics().evaluations();
      Run run = Run.of(new Switching(settings), rotation, 0, start, tEnd);
      long evaluations = run.statistics().evaluations();
      assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
      assertThat(run.atEnd())
          .containsExactly(
              new double[] {StrictMath.cos(slow * tEnd), StrictMath.sin(slow * tEnd)},
              within(100 * tolerance));
      assertThat(evaluations)
          .as("decay %s, tolerance %s, rate %s, to %s", decay, tolerance, slow, tEnd)
          .isLessThanOrEqualTo(3 * stiff);
      // Finding out takes up to six steps of two evaluations, and some tries.
      close += evaluations <= Math.max(1.3 * stiff, stiff + 20.0) ? 1 : 0;
    }
    assertThat(close).isGreaterThanOrEqualTo((int) (0.95 * runs));
  }

  /** A point that moves towards another on a slow circle while it rotates about that, fast. */
  private static FunctionOde rotation(double fast, double decay, double slow) {
    return new FunctionOde(
        2,
        (t, y, yDot) -> {
          double cosine = StrictMath.cos(slow * t);
          double sine = StrictMath.sin(slow * t);
          double u = y[0] - cosine;
          double v = y[1] - sine;
          yDot[0] = -decay * u - fast * v - slow * sine;
          yDot[1] = fast * u - decay * v + slow * cosine;
        });
  }

  /** The same decay in units in which powers of time and of the state overflow. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-100, 1e-140, 1e-150, 1e-153, 1e150})
  void unitsDoNotDecideWhenTheMethodChanges(double unit) {
    for (double tolerance : new double[] {1e-4, 1e-8}) {
      Run usual = decay(1, tolerance);
      Run other = decay(unit, tolerance);
      assertThat(other.result()).isEqualTo(StepResult.REACHED_END);
      assertThat(other.integrator().methodChangeCount())
          .isEqualTo(usual.integrator().methodChangeCount())
          .isPositive();
      assertThat(other.statistics().evaluations()).isLessThan(2 * usual.statistics().evaluations());
    }
  }

  private static Run decay(double unit, double tolerance) {
    FunctionOde stiff =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = -1000 * (y[0] - y[1]) / unit;
              yDot[1] = -y[1] / unit;
            });
    IntegratorSettings settings = new IntegratorSettings(tolerance, tolerance * unit);
    double[] start = {2 * unit, unit};
    return Run.of(new Switching(settings), stiff, 0, start, 3 * unit);
  }
}
