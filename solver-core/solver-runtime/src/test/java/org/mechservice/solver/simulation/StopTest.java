package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;

/** How soon a run hears that it is to stop: counted in evaluations, not in seconds. */
class StopTest {
  /** Van der Pol's oscillator, stiff: q'' = mu (1 - q^2) q' - q. Asks for a stop in the midst. */
  private static final class Stiff extends HarmonicOscillator {
    private static final double MU = 1000;

    private final RunControl control;
    private final long stopAt;
    private long evaluations;

    Stiff(RunControl control, long stopAt) {
      this.control = control;
      this.stopAt = stopAt;
    }

    @Override
    public void initialState(double[] y) {
      y[0] = 2;
      y[1] = 0;
    }

    @Override
    public int derivative(double t, double[] y, double[] yDot) {
      evaluations++;
      if (evaluations == stopAt) {
        control.stop();
      }
      yDot[0] = y[1];
      yDot[1] = MU * (1 - y[0] * y[0]) * y[1] - y[0];
      return REGULAR;
    }
  }

  /**
   * A long run spends most of its evaluations inside Newton iterations and Jacobians; a stop asked
   * for within any of 100 evaluations on end meets all of them.
   */
  @ParameterizedTest
  @CsvSource({"ode15s, 1", "ode15s, 400", "ode15sR, 1", "ode15sR, 400", "ode113, 1", "DE, 400"})
  void noEvaluationIsMadeAfterTheOneInWhichAStopWasAskedFor(String integrator, int first)
      throws IOException {
    RunSettings settings = new RunSettings(0, 3000, 1, integrator, 1e-6, 1e-9);
    for (int stopAt = first; stopAt < first + 100; stopAt++) {
      RunControl control = new RunControl();
      Stiff model = new Stiff(control, stopAt);
      RunReport report =
          new RuntimeSolver()
              .run(model, new RunRequest(settings, Set.of()), new RecordedRows(), control);
      assertThat(report.outcome()).isInstanceOf(Outcome.Stopped.class);
      assertThat(model.evaluations - stopAt).as("stop within evaluation %d", stopAt).isZero();
    }
  }
}
