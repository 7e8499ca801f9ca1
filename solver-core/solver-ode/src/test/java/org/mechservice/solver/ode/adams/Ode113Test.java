package org.mechservice.solver.ode.adams;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.ode.AdamsContract;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.suite.DetestA3;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.suite.SuiteProblem;

class Ode113Test extends AdamsContract {
  @Override
  protected Integrator create(IntegratorSettings settings) {
    return new Ode113(settings);
  }

  /**
   * Counts of an independent prototype of the same specification. 3 % of steps and evaluations, the
   * larger of 3 and 10 % of the failures: rounding decides close calls.
   */
  @ParameterizedTest
  @CsvSource({
    "EulerRigidBody, 1e-3, 67, 0, 135",
    "EulerRigidBody, 1e-6, 168, 0, 337",
    "EulerRigidBody, 1e-9, 282, 0, 565",
    "VanDerPol, 1e-3, 143, 9, 296",
    "VanDerPol, 1e-6, 329, 7, 666",
    "VanDerPol, 1e-9, 584, 6, 1175",
    "Kepler, 1e-3, 244, 23, 512",
    "Kepler, 1e-6, 521, 23, 1066",
    "Kepler, 1e-9, 927, 22, 1877",
    "Arenstorf, 1e-3, 147, 7, 302",
    "Arenstorf, 1e-6, 370, 18, 759",
    "Arenstorf, 1e-9, 668, 13, 1350",
    "Pleiades, 1e-3, 227, 18, 473",
    "Pleiades, 1e-6, 523, 22, 1069",
    "Pleiades, 1e-9, 906, 22, 1835",
    "DetestA3, 1e-3, 75, 3, 154",
    "DetestA3, 1e-6, 144, 2, 291",
    "DetestA3, 1e-9, 239, 0, 479",
    "SixLinkChain, 1e-3, 127, 7, 262",
    "SixLinkChain, 1e-6, 284, 5, 574",
    "SixLinkChain, 1e-9, 547, 8, 1103",
  })
  void costsWhatTheReferenceProgramCosts(
      String problem, double tolerance, double steps, double failed, double evaluations) {
    SuiteProblem posed = SuiteProblem.named(problem);
    IntegrationStatistics cost = Run.of(create(Run.settings(posed, tolerance)), posed).statistics();
    assertThat((double) cost.steps()).as("steps").isCloseTo(steps, within(0.03 * steps));
    assertThat((double) cost.rejectedSteps())
        .as("failed steps")
        .isCloseTo(failed, within(Math.max(3, 0.1 * failed)));
    assertThat((double) cost.evaluations())
        .as("evaluations")
        .isCloseTo(evaluations, within(0.03 * evaluations));
  }

  @Test
  void endsExactlyAtTheEnd() {
    Run run = Run.of(create(new IntegratorSettings(1e-6, 1e-6)), new DetestA3());
    assertThat(run.integrator().time()).isEqualTo(20);
  }

  @Test
  void takesAtLeastTenStepsUnlessALongerOneIsAllowed() {
    FunctionOde constant = new FunctionOde(1, (t, y, yDot) -> yDot[0] = 0);
    Run run = Run.of(create(new IntegratorSettings(1e-6, 1e-6)), constant, 0, new double[] {1}, 5);
    assertThat(run.statistics().steps()).isEqualTo(10);
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
    Run.of(create(new IntegratorSettings(1e-6, 1e-6)), watched, 0, new double[] {1}, 20);
    assertThat(latest[0]).isEqualTo(20);
  }
}
