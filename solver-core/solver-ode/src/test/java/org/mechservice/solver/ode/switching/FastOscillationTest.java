package org.mechservice.solver.ode.switching;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.MaximumNorm;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.Run;

/** Fast oscillations: those that are not there, those that are, and those that should be gone. */
class FastOscillationTest {
  private static final double TOLERANCE = 1e-6;

  /** y' = (−decay + i fast) (y − e^{it}) + i e^{it}. */
  private static FunctionOde rotation(double fast, double decay) {
    return new FunctionOde(
        2,
        (t, y, yDot) -> {
          double u = y[0] - StrictMath.cos(t);
          double v = y[1] - StrictMath.sin(t);
          yDot[0] = -decay * u - fast * v - StrictMath.sin(t);
          yDot[1] = fast * u - decay * v + StrictMath.cos(t);
        });
  }

  private static Run run(Integrator integrator, FunctionOde ode, double start, double end) {
    return Run.of(integrator, ode, 0, new double[] {start, 0}, end);
  }

  /**
   * Of 20 to 60 evaluations of ode15s, which takes no damped oscillation for a pulse; the start
   * takes four more before ode15s is at work.
   */
  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-4, 1e-5, 1e-6, 1e-8})
  void startOnTheSlowSolutionIsStiffFromTheFirstStepOn(double tolerance) {
    for (double decay : new double[] {1e2, 1e4, 1e6}) {
      IntegratorSettings settings = new IntegratorSettings(tolerance, tolerance);
      Run stiff = run(new Ode15s(settings), rotation(1e5, decay), 1, 1);
      Run changing = run(new Switching(settings), rotation(1e5, decay), 1, 1);
      assertThat(stiff.statistics().rejectedSteps()).isZero();
      assertThat(stiff.statistics().evaluations()).isLessThanOrEqualTo(60);
      assertThat(changing.integrator().methodChanges()).hasSize(1);
      assertThat(changing.integrator().methodChanges().get(0).time()).isLessThan(1e-3);
      assertThat(changing.statistics().evaluations())
          .isLessThanOrEqualTo((long) (1.3 * stiff.statistics().evaluations()));
      assertThat(changing.atEnd())
          .containsExactly(
              new double[] {StrictMath.cos(1), StrictMath.sin(1)}, within(10 * tolerance));
    }
  }

  /** The oscillation has decayed by e^120 at the end, but ode113 keeps it at many tolerances. */
  @Test
  void oscillationThatOnlyTheMethodKeepsAliveIsEnded() {
    IntegratorSettings settings = new IntegratorSettings(TOLERANCE, TOLERANCE);
    FunctionOde ode = rotation(1e5, 300);
    Run explicit = run(new Ode113(settings), ode, 1.1, 0.4);
    Run changing = run(new Switching(settings), ode, 1.1, 0.4);
    double[] exact = {StrictMath.cos(0.4), StrictMath.sin(0.4)};
    assertThat(Math.abs(explicit.atEnd()[0] - exact[0])).isGreaterThan(10 * TOLERANCE);
    assertThat(changing.atEnd()).containsExactly(exact, within(10 * TOLERANCE));
    assertThat(changing.integrator().methodChangeCount()).isEqualTo(1);
    assertThat(changing.statistics().evaluations())
        .isLessThan(explicit.statistics().evaluations() / 2);
  }

  /** Nothing damps it: it has to be followed, with the bits of ode113, at its cost. */
  @Test
  void oscillationThatLastsIsFollowed() {
    IntegratorSettings settings = new IntegratorSettings(1e-3, 1e-3);
    FunctionOde ode = rotation(1e3, 0);
    Run explicit = run(new Ode113(settings), ode, 2, 10);
    Run changing = run(new Switching(settings), ode, 2, 10);
    assertThat(explicit.statistics().steps()).isGreaterThan(10_000);
    assertThat(changing.integrator().methodChangeCount()).isZero();
    assertThat(changing.atEnd()).isEqualTo(explicit.atEnd());
    // Looked at once more whenever the steps have doubled, by two evaluations.
    assertThat(changing.statistics().evaluations() - explicit.statistics().evaluations())
        .isBetween(0L, 10L);
  }

  private static FastestMotionProbe probe(FunctionOde ode) {
    MaximumNorm norm = new MaximumNorm();
    norm.begin(TOLERANCE, new double[] {TOLERANCE, TOLERANCE}, new Manifold(ode));
    norm.weigh(new double[] {1, 1});
    return new FastestMotionProbe(ode, (ErrorNorm) norm);
  }

  private static double decay(FunctionOde ode, double[] direction) {
    double[] y = {1, 0.1};
    double[] slope = new double[2];
    ode.derivative(0.2, y, slope);
    return probe(ode).decay(0.2, y, slope, direction);
  }

  @Test
  void decayIsReadFromTwoProducts() {
    double[] direction = {0.3, -0.2};
    assertThat(decay(rotation(1e5, 300), direction)).isCloseTo(300, within(1.0));
    assertThat(decay(rotation(1e5, 0), direction)).isCloseTo(0, within(1.0));
    assertThat(decay(rotation(1e5, -50), direction)).isCloseTo(-50, within(1.0));
  }

  @Test
  void stopBeforeTheFirstStepIsTakenUpWithTheSameBits() {
    IntegratorSettings settings = new IntegratorSettings(1e-5, 1e-5);
    boolean[] stop = {false};
    IntegratorSettings stoppable =
        new IntegratorSettings(
            1e-5,
            settings.absoluteTolerance(),
            Double.POSITIVE_INFINITY,
            0,
            0,
            Long.MAX_VALUE,
            () -> stop[0]);
    for (double start : new double[] {1, 1.1}) {
      FunctionOde ode = rotation(1e4, 1e3);
      Run whole = run(new Switching(settings), ode, start, 1);
      Switching cut = new Switching(stoppable);
      cut.start(ode, 0, new double[] {start, 0}, 1);
      stop[0] = true;
      assertThat(cut.step()).isEqualTo(StepResult.STOPPED);
      stop[0] = false;
      StepResult result = StepResult.ADVANCED;
      while (result == StepResult.ADVANCED) {
        result = cut.step();
      }
      assertThat(Run.state(cut, 1, 2)).isEqualTo(whole.atEnd());
      assertThat(cut.methodChanges()).isEqualTo(whole.integrator().methodChanges());
    }
  }
}
