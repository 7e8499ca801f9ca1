package org.mechservice.solver.ode.adams;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.ode.AdamsContract;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.suite.DetestA3;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.suite.SuiteProblem;

class DeTest extends AdamsContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new De(settings);
  }

  /** Counts of the original program (netlib ODE), run on the same problems; 2 % for rounding. */
  @ParameterizedTest
  @CsvSource({
    "EulerRigidBody, 1e-3, 133",
    "EulerRigidBody, 1e-6, 337",
    "EulerRigidBody, 1e-9, 555",
    "VanDerPol, 1e-6, 662",
    "Kepler, 1e-3, 486",
    "Kepler, 1e-6, 1029",
    "Kepler, 1e-9, 1814",
    "Arenstorf, 1e-3, 292",
    "Arenstorf, 1e-6, 782",
    "Arenstorf, 1e-9, 1345",
    "Pleiades, 1e-3, 469",
    "Pleiades, 1e-6, 1058",
    "Pleiades, 1e-9, 1861",
    "DetestA3, 1e-6, 294",
    "SixLinkChain, 1e-3, 242",
    "SixLinkChain, 1e-6, 586",
    "SixLinkChain, 1e-9, 1088",
  })
  void costsWhatTheOriginalCosts(String problem, double tolerance, double evaluations) {
    SuiteProblem posed = SuiteProblem.named(problem);
    IntegrationStatistics cost = Run.of(create(Run.settings(posed, tolerance)), posed).statistics();
    assertThat((double) cost.evaluations()).isCloseTo(evaluations, within(0.02 * evaluations));
  }

  /** Correct digits of the original program on the same runs; chaos in rounding leaves 0.3. */
  @ParameterizedTest
  @CsvSource({
    "EulerRigidBody, 1e-3, 2.4",
    "EulerRigidBody, 1e-6, 5.5",
    "EulerRigidBody, 1e-9, 8.7",
    "Kepler, 1e-3, 0.2",
    "Kepler, 1e-6, 3.3",
    "Kepler, 1e-9, 7.5",
    "Pleiades, 1e-3, 0.6",
    "Pleiades, 1e-6, 3.6",
    "Pleiades, 1e-9, 6.7",
    "Arenstorf, 1e-3, 0.2",
    "Arenstorf, 1e-6, 2.2",
    "Arenstorf, 1e-9, 5.2",
    "SixLinkChain, 1e-3, 3.0",
    "SixLinkChain, 1e-6, 5.7",
    "SixLinkChain, 1e-9, 9.2",
  })
  void isAsAccurateAsTheOriginal(String problem, double tolerance, double digits) {
    SuiteProblem posed = SuiteProblem.named(problem);
    double[] atEnd = Run.of(create(Run.settings(posed, tolerance)), posed).atEnd();
    assertThat(posed.reference().mixedDigits(atEnd, posed.reference().atEnd()))
        .isCloseTo(digits, within(0.3));
  }

  @Test
  void stepsPastTheEndAndInterpolatesThereWhileTimeDoesNotLiePastIt() {
    Run run = Run.of(create(new IntegratorSettings(1e-8, 1e-8)), new DetestA3());
    assertThat(run.integrator().time()).isEqualTo(20);
    assertThat(run.integrator().previousTime()).isLessThan(20);
    assertThat(run.integrator().previousTime() + run.integrator().stepSize()).isGreaterThan(20);
    assertThat(run.atEnd()[0]).isCloseTo(new DetestA3().exact(20)[0], within(1e-6));
  }

  @Test
  void neverGoesBeyondTenIntervals() {
    double[] latest = {0};
    FunctionOde watched =
        new FunctionOde(
            1,
            (t, y, yDot) -> {
              latest[0] = Math.max(latest[0], t);
              yDot[0] = 0;
            });
    IntegratorSettings hugeFirstStep =
        new IntegratorSettings(
            1e-6, List.of(1e-6), Double.POSITIVE_INFINITY, 1e9, 0, Long.MAX_VALUE, () -> false);
    Run.of(create(hugeFirstStep), watched, 0, new double[] {1}, 5);
    assertThat(latest[0]).isEqualTo(50);
  }

  @Test
  void toleranceBelowTheRoundOffOfManyComponentsIsReported() {
    // 2u √n / rtol > ½: 1000 components of size 1 at the smallest tolerance.
    FunctionOde many = new FunctionOde(1000, (t, y, yDot) -> Arrays.fill(yDot, 0));
    double[] y0 = new double[1000];
    Arrays.fill(y0, 1);
    Run run = Run.of(create(new IntegratorSettings(2.3e-14, 1e-300)), many, 0, y0, 1);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    assertThat(run.integrator().failure().cause())
        .isEqualTo(IntegrationFailure.Cause.TOLERANCE_TOO_TIGHT);
  }

  @Test
  void moreThan500StepsAreTaken() {
    SuiteProblem problem = SuiteProblem.named("FastOscillator");
    Run run = Run.of(create(Run.settings(problem, 1e-6)), problem);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(run.statistics().steps()).isGreaterThan(500);
  }
}
