package org.mechservice.solver.ode.stiff;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorContract;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.JacobianSystem;
import org.mechservice.solver.ode.SparseSystem;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.backward.BackwardFormulas;
import org.mechservice.solver.ode.suite.Banded;
import org.mechservice.solver.ode.suite.Brusselator;
import org.mechservice.solver.ode.suite.DetestA3;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.suite.StiffVanDerPol;
import org.mechservice.solver.ode.suite.SuiteProblem;
import org.mechservice.solver.ode.suite.VerifiedValues;

class Ode15sTest extends IntegratorContract {
  /** y' = y, whose iteration matrix 1 − hγ is singular at h = 1 for BDF of order 1. */
  private static final FunctionOde GROWTH = new FunctionOde(1, (t, y, yDot) -> yDot[0] = y[0]);

  /** Slides into y = 0 at t = 1, where no step has a solution and f no derivative. */
  private static final FunctionOde SLIDING =
      new FunctionOde(1, (t, y, yDot) -> yDot[0] = y[0] > 0 ? -1 : 1);

  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Ode15s(settings);
  }

  /** Two to three digits: an error per step of low order, made many times. */
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
   * Counts of the original program, and of an independent prototype of the same specification, at
   * the default tolerances; 2 % for rounding.
   */
  @ParameterizedTest
  @CsvSource({
    "3000, 591, 225, 1883, 45, 289, 1747",
    "2000, 408, 149, 1266, 30, 197, 1175",
    "6000, 1366, 522, 4333, 98, 654, 4038",
  })
  void costsWhatTheOriginalCostsOnRelaxationOscillations(
      double end,
      double steps,
      double failed,
      double evaluations,
      double jacobians,
      double factorisations,
      double solutions) {
    SuiteProblem problem = new StiffVanDerPol();
    Integrator integrator = create(Run.settings(problem, 1e-3).withMode(Mode.FAITHFUL));
    IntegrationStatistics cost =
        Run.of(integrator, problem, 0, problem.reference().initialState(), end).statistics();
    assertClose("steps", cost.steps(), steps, 0.02 * steps);
    assertClose("failed", cost.rejectedSteps(), failed, 0.02 * failed);
    assertClose("evaluations", cost.evaluations(), evaluations, 0.02 * evaluations);
    assertClose("Jacobians", cost.jacobians(), jacobians, 0.02 * jacobians);
    assertClose("LU", cost.factorisations(), factorisations, 0.02 * factorisations);
    assertClose("solutions", cost.solutions(), solutions, 0.02 * solutions);
  }

  /**
   * Counts of an independent prototype of the same specification. 3 % of steps and evaluations, the
   * larger of 3 and 10 % of the rest: rounding decides close calls.
   */
  @ParameterizedTest
  @CsvSource({
    "EulerRigidBody, 1e-3, 87, 5, 180, 1, 19",
    "EulerRigidBody, 1e-6, 274, 5, 438, 1, 28",
    "EulerRigidBody, 1e-9, 815, 5, 931, 1, 49",
    "VanDerPol, 1e-3, 176, 30, 384, 1, 55",
    "VanDerPol, 1e-6, 578, 43, 968, 1, 104",
    "VanDerPol, 1e-9, 1708, 50, 2300, 1, 157",
    "Kepler, 1e-3, 368, 77, 749, 3, 134",
    "Kepler, 1e-6, 852, 72, 1220, 2, 158",
    "Kepler, 1e-9, 2514, 76, 3049, 2, 294",
    "Arenstorf, 1e-3, 183, 22, 393, 4, 53",
    "Arenstorf, 1e-6, 605, 47, 967, 3, 103",
    "Arenstorf, 1e-9, 1832, 54, 2710, 2, 198",
    "Pleiades, 1e-3, 287, 50, 570, 1, 89",
    "Pleiades, 1e-6, 911, 65, 1167, 1, 144",
    "Pleiades, 1e-9, 2771, 75, 3162, 1, 273",
    "DetestA3, 1e-3, 86, 22, 205, 5, 37",
    "DetestA3, 1e-6, 289, 30, 522, 1, 65",
    "DetestA3, 1e-9, 818, 47, 1221, 1, 120",
    "SixLinkChain, 1e-3, 157, 26, 434, 5, 47",
    "SixLinkChain, 1e-6, 488, 29, 809, 1, 75",
    "SixLinkChain, 1e-9, 1490, 35, 1801, 1, 126",
    "Robertson, 1e-3, 310, 15, 667, 10, 77",
    "Robertson, 1e-6, 872, 18, 1607, 10, 151",
    "Robertson, 1e-9, 2226, 20, 4053, 10, 334",
    "Hires, 1e-3, 118, 20, 375, 11, 44",
    "Hires, 1e-6, 359, 24, 818, 8, 74",
    "Hires, 1e-9, 1066, 58, 2309, 6, 182",
    "StiffVanDerPol, 1e-3, 408, 149, 1266, 30, 197",
    "StiffVanDerPol, 1e-6, 1355, 159, 3115, 16, 237",
    "StiffVanDerPol, 1e-9, 3995, 240, 7546, 14, 483",
    "Brusselator, 1e-3, 72, 8, 242, 2, 21",
    "Brusselator, 1e-6, 225, 8, 456, 1, 36",
    "Brusselator, 1e-9, 646, 12, 1035, 1, 77",
    "StiffChain, 1e-3, 364, 33, 533, 1, 89",
    "StiffChain, 1e-6, 766, 7, 1554, 1, 63",
    "StiffChain, 1e-9, 2387, 16, 3985, 1, 126",
  })
  void costsWhatTheReferenceProgramCosts(
      String problem,
      double tolerance,
      double steps,
      double failed,
      double evaluations,
      double jacobians,
      double factorisations) {
    SuiteProblem posed = SuiteProblem.named(problem);
    Integrator faithful = create(Run.settings(posed, tolerance).withMode(Mode.FAITHFUL));
    IntegrationStatistics cost = Run.of(faithful, posed).statistics();
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

  @Test
  void backwardDifferentiationFormulasTakeMoreStepsAtTheSameOrder() {
    // 26 % longer steps of order 2 at the same error; start and jumps of the step leave some.
    IntegratorSettings settings = withMaxOrder(1e-6, 2);
    double ndf = Run.of(new Ode15s(settings), new DetestA3()).statistics().steps();
    double bdf =
        Run.of(new Ode15s(settings, BackwardFormulas.BDF), new DetestA3()).statistics().steps();
    assertThat(bdf / ndf).isBetween(1.15, 1.35);
  }

  // Stiffness

  @ParameterizedTest
  @ValueSource(doubles = {1e-4, 1e-6, 1e-8})
  void checkpointsOfStiffProblemsAreMetAsWellAsAStepEndThere(double tolerance) {
    assertCheckpointsAreMet(SuiteProblem.stiff(), tolerance);
  }

  @Test
  void stepsDoNotDependOnTheFastestRateOnceItHasDiedOut() {
    Run stiff = relaxation(-1e3);
    Run stiffer = relaxation(-1e9);
    // The start is six decades shorter: up to 7 steps, at order 5, for each factor of 10.
    assertThat(stiffer.statistics().steps()).isLessThan(stiff.statistics().steps() + 42);
  }

  private Run relaxation(double rate) {
    FunctionOde ode =
        new FunctionOde(1, (t, y, yDot) -> yDot[0] = rate * (y[0] - StrictMath.cos(t)));
    return Run.of(create(1e-6), ode, 0, new double[] {2}, 10);
  }

  @Test
  void tinyFirstStepIsOutgrownWithinFifteenPercentMoreSteps() {
    SuiteProblem problem = SuiteProblem.named("Robertson");
    IntegratorSettings chosen = Run.settings(problem, 1e-6);
    IntegratorSettings tiny =
        new IntegratorSettings(
            chosen.relativeTolerance(),
            chosen.absoluteTolerance(),
            chosen.maxStep(),
            1e-30,
            0,
            Long.MAX_VALUE,
            () -> false);
    double usual = Run.of(create(chosen), problem).statistics().steps();
    assertThat((double) Run.of(create(tiny), problem).statistics().steps())
        .isLessThan(1.15 * usual);
  }

  // Jacobian

  @Test
  void bandTakesTheSameStepsWithFewerEvaluations() {
    SuiteProblem full = new Brusselator();
    // Elsewhere derivatives that are cheap are renewed earlier.
    IntegratorSettings settings = Run.settings(full, 1e-6).withMode(Mode.FAITHFUL);
    Run dense = Run.of(create(settings), full);
    Run banded = Run.of(create(settings), new Banded(full, 2, 2));
    long jacobians = dense.statistics().jacobians();
    assertThat(banded.atEnd()).isEqualTo(dense.atEnd());
    // 5 groups of columns instead of 40 columns.
    assertThat(banded.statistics().evaluations())
        .isEqualTo(dense.statistics().evaluations() - 35 * jacobians);
  }

  /** The Brusselator: each species diffuses, and reacts with the other at its own point. */
  private record Patterned(SuiteProblem problem) implements SuiteProblem, SparseSystem {
    @Override
    public VerifiedValues reference() {
      return problem.reference();
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {
      problem.derivative(t, y, yDot);
    }

    @Override
    public boolean couples(int equation, int component) {
      return Math.abs(equation - component) == 2 || equation / 2 == component / 2;
    }
  }

  @Test
  void patternTakesTheSameStepsWithFewerEvaluations() {
    SuiteProblem full = new Brusselator();
    IntegratorSettings settings = Run.settings(full, 1e-6).withMode(Mode.FAITHFUL);
    Run dense = Run.of(create(settings), full);
    Run sparse = Run.of(create(settings), new Patterned(full));
    long jacobians = dense.statistics().jacobians();
    assertThat(sparse.atEnd()).isEqualTo(dense.atEnd());
    // 4 groups of columns, one fewer than as a band.
    assertThat(sparse.statistics().evaluations())
        .isEqualTo(dense.statistics().evaluations() - 36 * jacobians);
  }

  @Test
  void bandWiderThanTheMatrixIsRefused() {
    SuiteProblem tooWide = new Banded(new DetestA3(), 1, 0);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> create(1e-6).start(tooWide, 0, new double[] {1}, 1))
        .withMessageContaining("number of diagonals below the main one is 1");
  }

  @Test
  void knownJacobianSparesTheDifferences() {
    SuiteProblem problem = new StiffVanDerPol();
    Run differenced = Run.of(create(Run.settings(problem, 1e-6)), problem);
    Run known = Run.of(create(Run.settings(problem, 1e-6)), new KnownJacobian(problem));
    IntegrationStatistics cost = known.statistics();
    // One evaluation per solution, one at the start, one for the change of f in time.
    assertThat(cost.evaluations()).isEqualTo(cost.solutions() + 2);
    assertThat((double) cost.steps())
        .isCloseTo((double) differenced.statistics().steps(), within(0.03 * cost.steps()));
  }

  /** Van der Pol's oscillator with its Jacobian. */
  private record KnownJacobian(SuiteProblem problem) implements SuiteProblem, JacobianSystem {
    @Override
    public int dimension() {
      return 2;
    }

    @Override
    public VerifiedValues reference() {
      return problem.reference();
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {
      problem.derivative(t, y, yDot);
    }

    @Override
    public void jacobian(double t, double[] y, double[] fy) {
      assertThat(fy).containsOnly(0);
      fy[1] = 1;
      fy[2] = -2000 * y[0] * y[1] - 1;
      fy[3] = 1000 * (1 - y[0] * y[0]);
    }
  }

  @Test
  void jacobianNotFiniteAtTheStartFailsNamingTheComponent() {
    JacobianSystem broken =
        new JacobianSystem() {
          @Override
          public int dimension() {
            return 2;
          }

          @Override
          public void derivative(double t, double[] y, double[] yDot) {
            yDot[0] = -y[0];
            yDot[1] = -y[1];
          }

          @Override
          public void jacobian(double t, double[] y, double[] fy) {
            fy[2] = Double.NaN;
          }
        };
    Run run = Run.of(create(1e-6), broken, 0, new double[] {1, 1}, 1);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    assertThat(run.integrator().failure().cause()).isEqualTo(IntegrationFailure.Cause.NOT_FINITE);
    assertThat(run.integrator().failure().worstComponent()).isEqualTo(1);
  }

  @Test
  void startAtTheEdgeOfTheDomainIsDifferencedInwards() {
    // f is not defined above y = 1, where it starts, and grows with y: differenced upwards first.
    FunctionOde edge = new FunctionOde(1, (t, y, yDot) -> yDot[0] = 1 - Math.sqrt(1 - y[0]));
    Run run = Run.of(create(1e-6), edge, 0, new double[] {1}, -0.5);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(run.atEnd()[0]).isLessThan(1);
  }

  // Equations that cannot be solved

  @Test
  void singularMatrixShortensTheStep() {
    Integrator integrator = new Ode15s(withFirstStep(1), BackwardFormulas.BDF);
    integrator.start(GROWTH, 0, new double[] {1}, 20);
    integrator.step();
    assertThat(integrator.statistics().rejectedSteps()).isPositive();
    assertThat(integrator.stepSize()).isLessThanOrEqualTo(0.3);
  }

  @Test
  void stepsWithoutSolutionAreReportedWhereTheyAre() {
    Run run = Run.of(create(1e-10), SLIDING, 0, new double[] {1}, 2);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    IntegrationFailure failure = run.integrator().failure();
    assertThat(failure.cause()).isEqualTo(IntegrationFailure.Cause.NO_CONVERGENCE);
    // Where y, which falls by one a second, is zero to within its tolerance in each of some fifty
    // steps, until they are too short for t.
    assertThat(failure.time()).isCloseTo(1, within(50 * 1e-10));
    assertThat(failure.worstComponent()).isZero();
    assertThat(failure.lastSteps().get(9).attempt()).isEqualTo(TrialOutcome.NOT_CONVERGING);
  }

  // Interruption and memory

  @Test
  void stopDuringTheJacobianIsTakenUpWhereItWas() {
    // 40 columns and a stop at every fifth question: begun anew, it would never be done.
    AtomicInteger asked = new AtomicInteger();
    SuiteProblem problem = new Brusselator();
    List<Double> tolerances = List.of(1e-4);
    Integrator stopped =
        create(
            new IntegratorSettings(
                1e-4,
                tolerances,
                Double.POSITIVE_INFINITY,
                0,
                0,
                Long.MAX_VALUE,
                () -> asked.incrementAndGet() % 5 == 0));
    StepResult result = stopped.start(problem, 0, problem.reference().initialState(), 10);
    while (result == StepResult.ADVANCED || result == StepResult.STOPPED) {
      result = stopped.step();
    }
    Run whole = Run.of(create(1e-4), problem);
    assertThat(Run.state(stopped, 10, 40)).isEqualTo(whole.atEnd());
    assertThat(stopped.statistics()).isEqualTo(whole.statistics());
  }

  @Test
  void newJacobiansAndFactorsAllocateNothing() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    SuiteProblem problem = new StiffVanDerPol();
    Integrator integrator = create(Run.settings(problem, 1e-4));
    long allocated = 0;
    // The first runs load classes; the last one is measured.
    for (int run = 0; run < 20; run++) {
      integrator.start(problem, 0, problem.reference().initialState(), 2000);
      long before = threads.getCurrentThreadAllocatedBytes();
      StepResult result;
      do {
        result = integrator.step();
      } while (result == StepResult.ADVANCED);
      allocated = threads.getCurrentThreadAllocatedBytes() - before;
    }
    assertThat(integrator.statistics().jacobians()).isGreaterThan(5);
    assertThat(allocated).isZero();
  }

  @Test
  void nothingIsEvaluatedBeyondTheEnd() {
    double[] latest = {0};
    FunctionOde watched =
        new FunctionOde(
            1,
            (t, y, yDot) -> {
              latest[0] = Math.max(latest[0], t);
              yDot[0] = y[0] * StrictMath.cos(t);
            });
    Run run = Run.of(create(1e-6), watched, 0, new double[] {1}, 20);
    assertThat(latest[0]).isEqualTo(20);
    assertThat(run.integrator().time()).isEqualTo(20);
  }
}
