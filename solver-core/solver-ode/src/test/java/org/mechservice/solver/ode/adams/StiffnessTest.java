package org.mechservice.solver.ode.adams;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.suite.SuiteProblem;

/** Stiffness is suspected where it limits the steps, soon, and nowhere else. */
class StiffnessTest {
  private static final FunctionOde DAMPED_OSCILLATOR =
      new FunctionOde(
          3,
          (t, y, yDot) -> {
            yDot[0] = -10 * y[0] + 100 * y[1];
            yDot[1] = -100 * y[0] - 10 * y[1];
            yDot[2] = -0.1 * y[2];
          });

  private static final FunctionOde STIFF_VAN_DER_POL =
      new FunctionOde(
          2,
          (t, y, yDot) -> {
            yDot[0] = y[1];
            yDot[1] = 1000 * (1 - y[0] * y[0]) * y[1] - y[0];
          });

  private static final FunctionOde ROBERTSON =
      new FunctionOde(
          3,
          (t, y, yDot) -> {
            yDot[0] = -0.04 * y[0] + 1e4 * y[1] * y[2];
            yDot[2] = 3e7 * y[1] * y[1];
            yDot[1] = -yDot[0] - yDot[2];
          });

  private static List<Integrator> integrators(IntegratorSettings settings) {
    return List.of(new Ode113(settings), new De(settings));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-6})
  void stiffProblemsAreSuspected(double tolerance) {
    IntegratorSettings settings = new IntegratorSettings(tolerance, 1e-3 * tolerance);
    for (Integrator integrator : integrators(settings)) {
      assertThat(suspects(integrator, DAMPED_OSCILLATOR, new double[] {1, 1, 1}, 20)).isTrue();
      assertThat(suspects(integrator, STIFF_VAN_DER_POL, new double[] {2, 0}, 2)).isTrue();
      assertThat(suspects(integrator, ROBERTSON, new double[] {1, 0, 0}, 1)).isTrue();
    }
  }

  @Test
  void stiffProblemsOfTheSuiteAreSuspectedWithinAThousandEvaluations() {
    // 95 % of the runs: some problems are not stiff so early at the tightest tolerances.
    int runs = 0;
    int suspected = 0;
    for (SuiteProblem problem : SuiteProblem.stiff()) {
      for (int k = 3; k <= 9; k++) {
        for (Integrator integrator : integrators(Run.settings(problem, StrictMath.pow(10, -k)))) {
          runs++;
          suspected += suspectsSoon(integrator, problem) ? 1 : 0;
        }
      }
    }
    assertThat((double) suspected / runs).isGreaterThanOrEqualTo(0.95);
  }

  private static boolean suspectsSoon(Integrator integrator, SuiteProblem problem) {
    double[] y0 = problem.reference().initialState();
    StepResult result = integrator.start(problem, 0, y0, problem.reference().end());
    while (result == StepResult.ADVANCED && integrator.statistics().evaluations() < 1000) {
      result = integrator.step();
    }
    return integrator.statistics().stiffnessSuspected();
  }

  private static boolean suspects(
      Integrator integrator, FunctionOde ode, double[] y0, double tEnd) {
    return Run.of(integrator, ode, 0, y0, tEnd).statistics().stiffnessSuspected();
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-12})
  void otherProblemsAreNot(double tolerance) {
    for (SuiteProblem problem : SuiteProblem.nonstiff()) {
      for (Integrator integrator : integrators(Run.settings(problem, tolerance))) {
        Run run = Run.of(integrator, problem);
        assertThat(run.statistics().stiffnessSuspected()).as(problem.name()).isFalse();
      }
    }
  }

  @Test
  void smallStepsByOrderOfTheUserAreNot() {
    IntegratorSettings bounded =
        new IntegratorSettings(1e-3, List.of(1e-3), 1e-3, 0, 0, Long.MAX_VALUE, () -> false);
    FunctionOde slow = new FunctionOde(1, (t, y, yDot) -> yDot[0] = y[0] * StrictMath.cos(t));
    FunctionOde atRest = new FunctionOde(1, (t, y, yDot) -> yDot[0] = 0);
    for (Integrator integrator : integrators(bounded)) {
      assertThat(suspects(integrator, slow, new double[] {1}, 2)).isFalse();
      assertThat(suspects(integrator, atRest, new double[] {1}, 2)).isFalse();
    }
  }
}
