package org.mechservice.solver.ode.stiff;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorContract;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.suite.DampedOscillator;
import org.mechservice.solver.ode.suite.Ode;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.suite.StiffChain;
import org.mechservice.solver.ode.suite.SuiteProblem;
import org.mechservice.solver.ode.switching.Switching;

/** The tuned mode does what every integrator does, with less work. */
class Ode15sTunedTest extends IntegratorContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Ode15s(settings.withMode(Mode.TUNED));
  }

  /** As in the standard mode. */
  @Override
  protected double accumulation() {
    return 1000;
  }

  @Override
  protected double notFiniteReduction() {
    return 0.3;
  }

  /** Where steps are long, differences that do not fall keep the order down. */
  @Override
  protected double toleranceOfOrders() {
    return 1e-5;
  }

  private static Run run(SuiteProblem problem, double tolerance, Mode mode) {
    return Run.of(new Ode15s(Run.settings(problem, tolerance).withMode(mode)), problem);
  }

  @Test
  void orderFallsNearTheImaginaryAxis() {
    // Eigenvalues −10 ± 100i: left to themselves, orders 4 and 5 take 4900 evaluations.
    Run run = run(new DampedOscillator(), 1e-6, Mode.TUNED);
    assertThat(run.statistics().evaluations()).isLessThanOrEqualTo(1300);
  }

  /** A mass on a spring whose other end moves, so damped that it follows within 0.01 s or less. */
  private static Ode stronglyDamped(double damping) {
    return new Ode(
        2,
        (t, y, yDot) -> {
          yDot[0] = y[1];
          yDot[1] = -damping * y[1] - 1e6 * (y[0] - StrictMath.sin(t));
        });
  }

  private static long evaluationsOfStronglyDamped(double damping, Integrator integrator) {
    Run run = Run.of(integrator, stronglyDamped(damping), 0, new double[] {1, 0}, 10);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    return run.statistics().evaluations();
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 4, 5, 6, 7, 8})
  void whatAChangeOfStepStirsUpDoesNotLowerTheOrder(int k) {
    // Heeded right after such changes, it keeps order 1 for up to nine times the evaluations.
    double tolerance = StrictMath.pow(10, -k);
    IntegratorSettings settings = new IntegratorSettings(tolerance, 0.01 * tolerance);
    Integrator tuned = new Ode15s(settings.withMode(Mode.TUNED));
    long standard = evaluationsOfStronglyDamped(1e4, new Ode15s(settings));
    assertThat(evaluationsOfStronglyDamped(1e4, tuned)).isLessThan(2 * standard);
    // Finding out takes evaluations too.
    assertThat(evaluationsOfStronglyDamped(1e4, new Switching(settings)))
        .isLessThan(2 * standard + 150);
  }

  @ParameterizedTest
  @ValueSource(doubles = {3e3, 1e4})
  void aStronglyDampedMassIsNotCaughtAtOrderOne(double damping) {
    // Caught on the way by one tolerance in ten, it would take 1.2 and 1.5 times the evaluations.
    double tuned = 0;
    double standard = 0;
    for (int i = 0; i <= 100; i++) {
      double tolerance = StrictMath.pow(10, -3 - 0.05 * i);
      IntegratorSettings settings = new IntegratorSettings(tolerance, 0.01 * tolerance);
      Ode15s inTunedMode = new Ode15s(settings.withMode(Mode.TUNED));
      tuned += StrictMath.log((double) evaluationsOfStronglyDamped(damping, inTunedMode));
      standard +=
          StrictMath.log((double) evaluationsOfStronglyDamped(damping, new Ode15s(settings)));
    }
    assertThat(tuned).isLessThan(standard);
  }

  @Test
  void linearProblemsTakeOneIterationPerStep() {
    IntegrationStatistics cost = run(new StiffChain(), 1e-6, Mode.TUNED).statistics();
    // And a second one after each factorisation, when the rate is not yet known, and now and then.
    double steps = cost.steps() + cost.rejectedSteps();
    assertThat((double) cost.solutions()).isLessThan(1.15 * steps);
  }

  @Test
  void evaluationsAtTheSameErrorAreAnEighthFewer() {
    // Log of the evaluations at the digits reached, on the average over tolerances and problems.
    double saved = 0;
    int problems = 0;
    for (String name :
        new String[] {"Robertson", "Hires", "StiffVanDerPol", "Brusselator", "StiffChain"}) {
      SuiteProblem problem = SuiteProblem.named(name);
      saved += evaluationsPerDigits(problem, Mode.FAITHFUL);
      saved -= evaluationsPerDigits(problem, Mode.TUNED);
      problems++;
    }
    assertThat(saved / problems).isGreaterThan(StrictMath.log(8.0 / 7));
  }

  /** Mean of ln f − (ln 10 / 3.5) (digits − 6): nearly the same whatever the tolerance. */
  private static double evaluationsPerDigits(SuiteProblem problem, Mode mode) {
    double sum = 0;
    int runs = 0;
    for (int k = 4; k <= 9; k++) {
      Run run = run(problem, StrictMath.pow(10, -k), mode);
      double digits = problem.reference().mixedDigits(run.atEnd(), problem.reference().atEnd());
      double evaluations = run.statistics().evaluations();
      sum += StrictMath.log(evaluations) - StrictMath.log(10) / 3.5 * (digits - 6);
      runs++;
    }
    return sum / runs;
  }

  @Test
  void aFifthOfTheFactorisationsIsSaved() {
    double faithful = 0;
    double tuned = 0;
    for (SuiteProblem problem : SuiteProblem.stiff()) {
      faithful += run(problem, 1e-6, Mode.FAITHFUL).statistics().factorisations();
      tuned += run(problem, 1e-6, Mode.TUNED).statistics().factorisations();
    }
    assertThat(tuned).isLessThan(0.8 * faithful);
  }
}
