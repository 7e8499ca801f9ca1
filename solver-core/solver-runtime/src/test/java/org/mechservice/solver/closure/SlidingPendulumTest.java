package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.closure.model.ProjectionModel;
import org.mechservice.solver.force.user.UserForceSource;

class SlidingPendulumTest {
  /** State at 10 s of the pendulum of 1 m released level, g = 9.81, by elliptic functions. */
  private static final double[] AT_TEN = {
    0.2750874625761168, -0.9614192050991250, -4.175598101950732, -1.1947490545604753
  };

  @ParameterizedTest
  @CsvSource({"ode113, 1e-6", "ode113, 1e-10", "DE, 1e-8", "ode15s, 1e-6"})
  void everyCoordinateTakesItsTurn(String integrator, double tolerance) {
    ClosedMechanism closed =
        new ClosedMechanism(
            Linkages.slidingPendulum(0), "DSR", SceneRun.settings(10, 0.5, integrator, tolerance));
    SceneRun run = SceneRun.of(new ProjectionModel(closed, UserForceSource.NONE));
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    double error = 0;
    for (int i = 0; i < 4; i++) {
      error = Math.max(error, Math.abs(run.at(10)[1 + i] - AT_TEN[i]));
    }
    assertThat(error).isCloseTo(0, within(1000 * tolerance));
  }
}
