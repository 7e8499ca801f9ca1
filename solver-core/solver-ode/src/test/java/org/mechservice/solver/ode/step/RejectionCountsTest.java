package org.mechservice.solver.ode.step;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.suite.StiffVanDerPol;
import org.mechservice.solver.ode.suite.SuiteProblem;
import org.mechservice.solver.ode.switching.Switching;

/** An integration tells which component made steps be rejected. */
class RejectionCountsTest {
  /** One component that hardly moves beside one that jumps from branch to branch. */
  private static final class Beside implements OdeSystem {
    private final SuiteProblem jumping = new StiffVanDerPol();
    private final double[] y = new double[2];
    private final double[] yDot = new double[2];

    @Override
    public int dimension() {
      return 3;
    }

    @Override
    public void derivative(double t, double[] all, double[] allDot) {
      System.arraycopy(all, 1, y, 0, 2);
      jumping.derivative(t, y, yDot);
      allDot[0] = -1e-6 * all[0];
      System.arraycopy(yDot, 0, allDot, 1, 2);
    }
  }

  private static IntegrationStatistics integrate(Integrator integrator) {
    double[] y0 = {1, 2, 0};
    Run run = Run.of(integrator, new Beside(), 0, y0, 2000);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    return run.statistics();
  }

  @Test
  void quietComponentIsNeverBlamed() {
    IntegrationStatistics done = integrate(new Ode15s(new IntegratorSettings(1e-6, 1e-6)));

    assertThat(done.limits()).extracting(IntegrationStatistics.Limit::component).doesNotContain(0);
    long named =
        done.limits().stream().mapToLong(limit -> limit.inaccurate() + limit.unsolved()).sum();
    assertThat(named).isEqualTo(done.rejectedSteps()).isPositive();
  }

  @Test
  void componentsAreSortedByHowOftenTheyLimit() {
    List<IntegrationStatistics.Limit> limits =
        integrate(new Ode15s(new IntegratorSettings(1e-4, 1e-4))).limits();

    assertThat(limits).isNotEmpty();
    for (int i = 1; i < limits.size(); i++) {
      IntegrationStatistics.Limit before = limits.get(i - 1);
      assertThat(before.inaccurate() + before.unsolved())
          .isGreaterThanOrEqualTo(limits.get(i).inaccurate() + limits.get(i).unsolved());
    }
  }

  @Test
  void valueThatIsNotFiniteIsCountedApart() {
    OdeSystem rooted =
        new FunctionOde(1, (t, y, yDot) -> yDot[0] = y[0] < 0 ? Double.NaN : -Math.sqrt(y[0]));
    Run run =
        Run.of(new Ode113(new IntegratorSettings(1e-6, 1e-6)), rooted, 0, new double[] {1}, 3);

    assertThat(run.statistics().limits().get(0).unsolved()).isPositive();
  }

  /** An oscillation that would take a thousand years of steps. */
  @Test
  void runWhoseEndIsOutOfReachEndsAfterAMillionSteps() {
    OdeSystem fast =
        new OdeSystem() {
          @Override
          public int dimension() {
            return 3;
          }

          @Override
          public void derivative(double t, double[] y, double[] yDot) {
            yDot[0] = -y[0];
            yDot[1] = y[2];
            yDot[2] = -1e40 * y[1];
          }
        };
    IntegratorSettings settings = new IntegratorSettings(1e-4, 1e-6);
    for (Integrator integrator :
        List.of(new Ode113(settings), new Ode15s(settings), new Switching(settings))) {
      Run run = Run.of(integrator, fast, 0, new double[] {1, 1, 0}, 1);
      assertThat(run.result()).isEqualTo(StepResult.FAILED);
      IntegrationFailure failure = integrator.failure();
      assertThat(failure.cause()).isEqualTo(IntegrationFailure.Cause.TOO_MANY_STEPS);
      assertThat(failure.worstComponent()).isPositive();
    }
  }
}
