package org.mechservice.solver.ode.stiff;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorContract;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.ResidualSystem;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.solve.Dae;
import org.mechservice.solver.ode.solve.DaeProblem;
import org.mechservice.solver.ode.suite.ExplicitAsResidual;
import org.mechservice.solver.ode.suite.ImplicitOde;
import org.mechservice.solver.ode.suite.PendulumWithMultiplier;
import org.mechservice.solver.ode.suite.ResidualProblem;
import org.mechservice.solver.ode.suite.ResidualRun;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.suite.SliderCrank;
import org.mechservice.solver.ode.suite.SuiteProblem;

/** In explicit form it does what every integrator does; in residual form, this. */
class Ode15sRTest extends IntegratorContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Ode15sR(settings);
  }

  /** As for ode15s. */
  @Override
  protected double accumulation() {
    return 1000;
  }

  @Override
  protected double notFiniteReduction() {
    return 0.3;
  }

  // Fidelity

  /**
   * Counts of an independent prototype of the same specification: 3 % of steps and evaluations, the
   * larger of 3 and 10 % of the rest.
   */
  @ParameterizedTest
  @CsvSource({
    "ConservedRobertson, 1e-6, 824, 13, 1593, 10, 140",
    "PendulumWithMultiplier, 1e-6, 738, 125, 2901, 101, 196",
    "SliderCrank, 1e-6, 1448, 206, 5188, 106, 348",
  })
  void costsWhatTheReferenceProgramCosts(
      String problem,
      double tolerance,
      double steps,
      double failed,
      double evaluations,
      double jacobians,
      double factorisations) {
    ResidualProblem posed = ResidualProblem.named(problem);
    Ode15sR faithful = new Ode15sR(ResidualRun.settings(posed, tolerance).withMode(Mode.FAITHFUL));
    IntegrationStatistics cost = ResidualRun.of(faithful, posed).statistics();
    assertClose("steps", cost.steps(), steps, 0.03 * steps);
    assertClose("failed", cost.rejectedSteps(), failed, few(failed));
    assertClose("evaluations", cost.evaluations(), evaluations, 0.03 * evaluations);
    assertClose("Jacobians", cost.jacobians(), jacobians, few(jacobians));
    assertClose("LU", cost.factorisations(), factorisations, few(factorisations));
  }

  private static double few(double expected) {
    return Math.max(3, 0.1 * expected);
  }

  private static void assertClose(String what, long actual, double expected, double tolerance) {
    assertThat((double) actual).as(what).isCloseTo(expected, within(tolerance));
  }

  /** The start alone differs: it takes up to 10 steps to outgrow a first step ten times shorter. */
  @ParameterizedTest
  @CsvSource({
    "EulerRigidBody",
    "VanDerPol",
    "Kepler",
    "Arenstorf",
    "Pleiades",
    "DetestA3",
    "SixLinkChain",
    "Robertson",
    "Hires",
    "StiffVanDerPol",
    "Brusselator",
    "StiffChain",
    "DampedOscillator"
  })
  void explicitProblemWrittenAsResidualCostsWhatOde15sCosts(String name) {
    SuiteProblem problem = SuiteProblem.named(name);
    IntegratorSettings settings = Run.settings(problem, 1e-6).withMode(Mode.FAITHFUL);
    IntegrationStatistics explicit = Run.of(new Ode15s(settings), problem).statistics();
    IntegrationStatistics implicit =
        ResidualRun.of(new Ode15sR(settings), new ExplicitAsResidual(problem)).statistics();
    double steps = explicit.steps();
    assertClose("steps", implicit.steps(), steps, Math.max(10, 0.02 * steps));
    // Each Jacobian takes n evaluations more, for the derivatives in y'.
    double evaluations =
        explicit.evaluations() + (double) implicit.jacobians() * (problem.dimension() + 1);
    assertClose(
        "evaluations", implicit.evaluations(), evaluations, Math.max(20, 0.02 * evaluations));
  }

  /**
   * A rotor of 0.05 kg m², and 1 kg that flies freely, in coordinates that turn with the rotor: M
   * is nearly singular, so that of the last step is of no use in the next.
   */
  private static final class FlyingFromRotor extends ImplicitOde {
    FlyingFromRotor() {
      super(6, FlyingFromRotor::evaluate);
    }

    @Override
    public boolean massMatrixMoves() {
      return true;
    }

    private static void evaluate(double t, double[] state, double[] rate, double[] residual) {
      double x = state[1];
      double y = state[2];
      double w = state[3];
      double ax = rate[4] - rate[3] * y - 2 * w * state[5] - w * w * x;
      double ay = rate[5] + rate[3] * x + 2 * w * state[4] - w * w * y;
      for (int i = 0; i < 3; i++) {
        residual[i] = rate[i] - state[3 + i];
      }
      residual[3] = 0.05 * rate[3] + x * ay - y * ax;
      residual[4] = ax;
      residual[5] = ay;
    }
  }

  /** The motion is uniform: what it takes is a matter of the turning axes alone. */
  private static Ode15sR flyFromRotor() {
    Ode15sR integrator = new Ode15sR(new IntegratorSettings(1e-6, 1e-8));
    // At (3, 4) m with (2, 0) m/s in the world; the axes turn at 2 rad/s.
    double[] start = {0, 3, 4, 2, 2 + 2 * 4, -2 * 3};
    double[] rate = {2, start[4], start[5], 0, -24 + 4 * 3, -40 + 4 * 4};
    StepResult result = integrator.start(new FlyingFromRotor(), 0, start, rate, 5);
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    assertThat(result).isEqualTo(StepResult.REACHED_END);
    return integrator;
  }

  @Test
  void massMatrixThatMovesCostsNoShortSteps() {
    Ode15sR integrator = flyFromRotor();
    double[] end = Run.state(integrator, 5, 6);
    // 131; with matrices formed where steps begin, and rates trusted, 10 998.
    assertThat(integrator.statistics().steps()).isLessThan(300);
    assertThat(end[0]).isCloseTo(10, within(1e-3));
    assertThat(StrictMath.hypot(end[1], end[2])).isCloseTo(StrictMath.hypot(13, 4), within(1e-3));
  }

  /** Before the iteration fails, the derivatives are formed anew. */
  @Test
  void massMatrixThatMovesSeldomMakesTheIterationFail() {
    IntegrationStatistics cost = flyFromRotor().statistics();
    long unsolved = cost.limits().stream().mapToLong(IntegrationStatistics.Limit::unsolved).sum();
    assertThat(unsolved).isLessThan(cost.steps() / 10);
  }

  // Accuracy

  @Test
  void invariantsDriftNoFasterThanTheErrorOfTheSolution() {
    for (ResidualProblem problem :
        new ResidualProblem[] {new PendulumWithMultiplier(), new SliderCrank()}) {
      ResidualRun run = ResidualRun.of(problem, 1e-8);
      double[] y = run.atEnd();
      double error = StrictMath.pow(10, -run.digits());
      assertThat(problem.invariants()).as(problem.name()).isNotEmpty();
      for (var invariant : problem.invariants()) {
        // Gradients up to 2 |y|, with |y| up to 4.
        assertThat(invariant.applyAsDouble(y)).isCloseTo(0, within(10 * error));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-4, 1e-6, 1e-8})
  void checkpointsAreMetAsWellAsAStepEndThere(double tolerance) {
    for (ResidualProblem problem : ResidualProblem.all()) {
      double t = problem.reference().checkpointTime();
      double[] y0 = problem.reference().initialState();
      Ode15sR integrator = ResidualRun.integrator(problem, tolerance);
      integrator.start(
          problem, problem.start(), y0, problem.initialDerivative(), problem.reference().end());
      do {
        assertThat(integrator.step()).isNotEqualTo(StepResult.FAILED);
      } while (integrator.time() < t);
      double[] inside = Run.state(integrator, t, y0.length);
      StepResult result =
          integrator.start(problem, problem.start(), y0, problem.initialDerivative(), t);
      while (result == StepResult.ADVANCED) {
        result = integrator.step();
      }
      double[] expected = problem.reference().atCheckpoint();
      double ended = problem.mixedDigits(Run.state(integrator, t, y0.length), expected);
      // One digit, from an error no smaller than the tolerance: a step end may be right by luck.
      assertThat(problem.mixedDigits(inside, expected))
          .as(problem.name())
          .isGreaterThanOrEqualTo(Math.min(ended, -StrictMath.log10(tolerance)) - 1);
    }
  }

  // Behaviour

  @Test
  void blowUpOfAResidualSystemIsReportedWhereItHappens() {
    ImplicitOde blowUp = new ImplicitOde(1, (t, y, yDot, r) -> r[0] = yDot[0] - y[0] * y[0]);
    Ode15sR integrator = new Ode15sR(new IntegratorSettings(1e-6, 1e-6));
    StepResult result = integrator.start(blowUp, 0, new double[] {1}, new double[] {1}, 2);
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    assertThat(result).isEqualTo(StepResult.FAILED);
    assertThat(integrator.failure().time()).isBetween(0.999, 1.0001);
    assertThat(integrator.failure().worstComponent()).isZero();
    assertThat(integrator.statistics().evaluations()).isLessThan(2000);
    assertThat(Run.state(integrator, integrator.time(), 1)[0]).isFinite();
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-6, 1e-9})
  void leavingTheDomainOfTheResidualIsReported(double tolerance) {
    ImplicitOde root = new ImplicitOde(1, (t, y, yDot, r) -> r[0] = yDot[0] + Math.sqrt(y[0]));
    Ode15sR integrator = new Ode15sR(new IntegratorSettings(tolerance, tolerance));
    StepResult result = integrator.start(root, 0, new double[] {1}, new double[] {-1}, 3);
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    if (result == StepResult.REACHED_END) {
      // The suite lets the solution rest at 0, which the equation does not exclude.
      assertThat(Run.state(integrator, 3, 1)[0]).isBetween(0.0, 10 * tolerance);
      return;
    }
    assertThat(result).isEqualTo(StepResult.FAILED);
    assertThat(integrator.failure().time()).isBetween(1.9, 2.1);
  }

  @Test
  void tinyFirstStepIsOutgrownWithinFifteenPercentMoreSteps() {
    ResidualProblem problem = ResidualProblem.named("ConservedRobertson");
    IntegratorSettings chosen = ResidualRun.settings(problem, 1e-6);
    IntegratorSettings tiny =
        new IntegratorSettings(
            chosen.relativeTolerance(),
            chosen.absoluteTolerance(),
            chosen.maxStep(),
            1e-30,
            0,
            Long.MAX_VALUE,
            () -> false);
    double usual = ResidualRun.of(problem, 1e-6).statistics().steps();
    ResidualRun run = ResidualRun.of(new Ode15sR(tiny), problem);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    assertThat((double) run.statistics().steps()).isLessThan(1.15 * usual);
  }

  @Test
  void constantSolutionOfAResidualSystemIsExactOverAnyInterval() {
    ImplicitOde constant =
        new ImplicitOde(3, (t, y, yDot, r) -> System.arraycopy(yDot, 0, r, 0, 3));
    double[] y0 = {1, -2e-300, 3e300};
    Ode15sR integrator = new Ode15sR(new IntegratorSettings(1e-6, 1e-6));
    StepResult result = integrator.start(constant, 0, y0, new double[3], 1e300);
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    assertThat(result).isEqualTo(StepResult.REACHED_END);
    assertThat(Run.state(integrator, 1e300, 3)).isEqualTo(y0);
    assertThat(integrator.statistics().steps()).isLessThan(400);
  }

  @Test
  void singularStepMatrixIsNamed() {
    // The second row says nothing about the second component.
    ImplicitOde silent =
        new ImplicitOde(
            2,
            (t, y, yDot, r) -> {
              r[0] = yDot[0] - 1;
              r[1] = 0;
            });
    Ode15sR integrator = new Ode15sR(new IntegratorSettings(1e-6, 1e-6));
    StepResult result = integrator.start(silent, 0, new double[2], new double[2], 1);
    assertThat(result).isEqualTo(StepResult.FAILED);
    assertThat(integrator.failure().cause()).isEqualTo(IntegrationFailure.Cause.SINGULAR_MATRIX);
    assertThat(integrator.failure().worstComponent()).isEqualTo(1);
  }

  // Consistent start

  @Test
  void consistentValuesAreLeftToTheBit() {
    for (ResidualProblem problem : ResidualProblem.all()) {
      Ode15sR integrator = ResidualRun.integrator(problem, 1e-6);
      double[] y0 = problem.reference().initialState();
      integrator.start(
          problem, problem.start(), y0, problem.initialDerivative(), problem.reference().end());
      double[] y = new double[y0.length];
      double[] yDot = new double[y0.length];
      integrator.interpolate(problem.start(), y, yDot);
      assertThat(y).as(problem.name()).isEqualTo(y0);
      assertThat(yDot).as(problem.name()).isEqualTo(problem.initialDerivative());
    }
  }

  @Test
  void accelerationsAndMultipliersAreFoundFromNothing() {
    ResidualProblem problem = new SliderCrank();
    Ode15sR integrator = ResidualRun.integrator(problem, 1e-6);
    double[] expected = problem.reference().initialState();
    double[] y0 = expected.clone();
    y0[6] = 0;
    y0[7] = 0;
    StepResult result = integrator.start(problem, 0, y0, new double[8], 1);
    assertThat(result).isEqualTo(StepResult.ADVANCED);
    double[] y = new double[8];
    double[] yDot = new double[8];
    integrator.interpolate(0, y, yDot);
    // One Newton step solves what is linear, up to the round-off of the differences.
    assertThat(y).containsExactly(expected, within(1e-8));
    assertThat(yDot).containsExactly(problem.initialDerivative(), within(1e-6));
  }

  @Test
  void cubicSlopeIsFoundFromAGuessFarOff() {
    // y'³ − 8 = 0 from y' = 100.
    ResidualSystem cubic = new ImplicitOde(1, (t, y, yDot, r) -> r[0] = Math.pow(yDot[0], 3) - 8);
    Ode15sR integrator = new Ode15sR(new IntegratorSettings(1e-8, 1e-8));
    integrator.start(cubic, 0, new double[] {1}, new double[] {100}, 1);
    double[] yDot = new double[1];
    integrator.interpolate(0, new double[1], yDot);
    assertThat(yDot[0]).isCloseTo(2, within(1e-9));
  }

  /**
   * As of a multiplier that balances stiff forces: a tenth of the error allowed is not to be had.
   */
  @Test
  void startIsTakenThatRoundingLeavesRightToTheErrorAllowedOnly() {
    ResidualSystem rounded =
        new ImplicitOde(
            2,
            (t, y, yDot, r) -> {
              double off = y[1] - 0.3;
              r[0] = yDot[0] + y[1];
              r[1] = off + Math.copySign(1e-9, off);
            }) {
          @Override
          public Component component(int index) {
            return index == 1 ? Component.ALGEBRAIC : Component.DIFFERENTIAL;
          }
        };
    Ode15sR integrator = new Ode15sR(new IntegratorSettings(1e-8, 1e-8));
    assertThat(integrator.start(rounded, 0, new double[] {1, 1}, new double[2], 1))
        .isEqualTo(StepResult.ADVANCED);
    double[] y = new double[2];
    integrator.interpolate(0, y, new double[2]);
    assertThat(y[1]).isCloseTo(0.3, within(1e-8));
  }

  @Test
  void contradictionAtTheStartNamesTheWorstRow() {
    Ode15sR integrator = new Ode15sR(new IntegratorSettings(1e-6, 1e-6));
    assertThat(integrator.start(held(2), 0, new double[] {1, 0}, new double[2], 1))
        .isEqualTo(StepResult.FAILED);
    assertThat(integrator.failure().cause()).isEqualTo(IntegrationFailure.Cause.INCONSISTENT_START);
    assertThat(integrator.failure().worstComponent()).isEqualTo(1);
  }

  /** No y' but r/h corrects a rounding r of a differential component: it is kept. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-14, 1e-12, 1e-11, 5e-11})
  void roundingOfAHeldComponentIsNoContradiction(double rounding) {
    Ode15sR integrator = new Ode15sR(new IntegratorSettings(1e-6, 1e-6));
    assertThat(integrator.start(held(2), 0, new double[] {2 + rounding, 0}, new double[2], 1))
        .isEqualTo(StepResult.ADVANCED);
  }

  /** y_0' = y_1, where the algebraic y_1 is to keep y_0 at a value. */
  private static ResidualSystem held(double value) {
    return new ImplicitOde(
        2,
        (t, y, yDot, r) -> {
          r[0] = yDot[0] - y[1];
          r[1] = y[0] - value;
        }) {
      @Override
      public Component component(int index) {
        return index == 1 ? Component.ALGEBRAIC : Component.DIFFERENTIAL;
      }
    };
  }

  @Test
  void residualNotFiniteAtTheStartNamesTheRow() {
    ResidualSystem broken =
        new ImplicitOde(
            2,
            (t, y, yDot, r) -> {
              r[0] = yDot[0];
              r[1] = Double.NaN;
            });
    Ode15sR integrator = new Ode15sR(new IntegratorSettings(1e-6, 1e-6));
    assertThat(integrator.start(broken, 0, new double[2], new double[2], 1))
        .isEqualTo(StepResult.FAILED);
    assertThat(integrator.failure().cause()).isEqualTo(IntegrationFailure.Cause.NOT_FINITE);
    assertThat(integrator.failure().worstComponent()).isEqualTo(1);
  }

  @Test
  void tolerancesBelowTheRoundOffOfTheEquationsAreRefusedByName() {
    // The currents of the transistors hang on differences of voltages of 5 V over 0.026 V: at 1e-11
    // all digits are delivered, a tenth of that is less than the equations can tell.
    ResidualProblem amplifier = ResidualProblem.named("TransistorAmplifier");
    assertThat(ResidualRun.of(amplifier, 1e-11).digits()).isGreaterThan(10);
    ResidualRun run = ResidualRun.of(amplifier, 1e-12);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    assertThat(run.integrator().failure().cause())
        .isEqualTo(IntegrationFailure.Cause.TOLERANCE_TOO_TIGHT);
    assertThat(run.integrator().failure().worstComponent()).isBetween(0, 7);
  }

  // Declarations

  /** Left out of the error test, an oscillator reached its end with an error of 0.77. */
  @ParameterizedTest
  @EnumSource
  void componentDeclaredAlgebraicWhoseDerivativeAppearsIsRefusedByName(Mode mode) {
    ResidualSystem oscillator =
        new ResidualSystem() {
          @Override
          public int dimension() {
            return 2;
          }

          @Override
          public void residual(double t, double[] y, double[] yDot, double[] residual) {
            residual[0] = yDot[1] + y[0];
            residual[1] = yDot[0] - y[1];
          }

          @Override
          public Component component(int index) {
            return Component.ALGEBRAIC;
          }
        };
    Ode15sR integrator = new Ode15sR(new IntegratorSettings(1e-6, 1e-6).withMode(mode));
    assertThatIllegalArgumentException()
        .isThrownBy(
            () -> integrator.start(oscillator, 0, new double[] {1, 0}, new double[] {0, -1}, 10))
        .withMessageContaining("component 0 is declared ALGEBRAIC")
        .withMessageContaining("derivative appears in equation 1 ")
        .withMessageEndingWith("declare it DIFFERENTIAL");
  }

  /** With y0 = t the coefficient of y1' is zero at the start alone; y1 ended at −3.3e8. */
  @Test
  void wrongDeclarationIsSeenWhereTheCoefficientIsZeroAtTheStart() {
    DaeProblem problem =
        Dae.system(
                2,
                (t, y, yDot, residual) -> {
                  residual[0] = yDot[0] - 1;
                  residual[1] = y[0] * yDot[1] + y[1] - y[0];
                })
            .withAlgebraic(1);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Dae.solve(problem, 0, new double[2], new double[] {1, 0.5}, 2))
        .withMessageContaining("component 1 is declared ALGEBRAIC")
        .withMessageContaining("derivative appears in equation 1 ")
        .withMessageEndingWith("declare it DIFFERENTIAL");
  }
}
