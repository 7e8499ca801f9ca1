package org.mechservice.solver.ode.stiff;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.LinearisedSystem;
import org.mechservice.solver.ode.ProjectedSystem;
import org.mechservice.solver.ode.ResidualJacobianSystem;
import org.mechservice.solver.ode.ResidualSystem;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.suite.ImplicitOde;
import org.mechservice.solver.ode.suite.LoopPendulum;
import org.mechservice.solver.ode.suite.PendulumWithMultiplier;
import org.mechservice.solver.ode.suite.ResidualRun;
import org.mechservice.solver.ode.suite.Run;

/** Systems in residual form that know more of themselves than their residual. */
class ResidualManifoldTest {
  private static final double[] SLOPE = {0, 0, 0, -9.81};

  private static Ode15sR integrator(double tolerance) {
    return new Ode15sR(new IntegratorSettings(tolerance, tolerance));
  }

  /** The pendulum as a loop; the residual says nothing about its passive coordinate. */
  private static final class LoopResidual extends LoopPendulum implements ResidualSystem {
    @Override
    public void residual(double t, double[] y, double[] yDot, double[] residual) {
      derivative(t, y, residual);
      for (int i = 0; i < 4; i++) {
        residual[i] = independent(i) ? yDot[i] - residual[i] : Double.NaN;
      }
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-4, 1e-6, 1e-8, 1e-10})
  void passiveComponentsFollowTheIndependentOnes(double tolerance) {
    LoopResidual pendulum = new LoopResidual();
    Ode15sR integrator = integrator(tolerance);
    ResidualSystem system = pendulum;
    StepResult result = integrator.start(system, 0, LoopPendulum.start(), SLOPE, 10);
    double[] y = new double[4];
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
      integrator.interpolate(integrator.time(), y, new double[4]);
      // Completed in closed form, so to round-off.
      assertThat(y[0] * y[0] + y[1] * y[1]).isCloseTo(1, within(1e-15));
    }
    assertThat(result).isEqualTo(StepResult.REACHED_END);
    assertThat(pendulum.changes()).isGreaterThan(15);
    // Low order: two to three times the steps of an Adams method, each with an error of one sign.
    assertThat(y).containsExactly(LoopPendulum.atTen(), within(5000 * tolerance));
  }

  @Test
  void loopInResidualFormCostsWhatItCostsInExplicitForm() {
    IntegratorSettings settings = new IntegratorSettings(1e-8, 1e-8).withMode(Mode.FAITHFUL);
    Ode15s explicit = new Ode15s(settings);
    double steps =
        Run.of(explicit, new LoopPendulum(), 0, LoopPendulum.start(), 10).statistics().steps();
    Ode15sR implicit = new Ode15sR(settings);
    ResidualSystem system = new LoopResidual();
    StepResult result = implicit.start(system, 0, LoopPendulum.start(), SLOPE, 10);
    while (result == StepResult.ADVANCED) {
      result = implicit.step();
    }
    // A shorter first step, and other round-off in other Jacobians.
    assertThat((double) implicit.statistics().steps()).isCloseTo(steps, within(0.05 * steps));
  }

  /** The pendulum with its multiplier, moved back onto the circle. */
  private static final class Projected implements ResidualSystem, ProjectedSystem {
    private final PendulumWithMultiplier pendulum = new PendulumWithMultiplier();

    @Override
    public int dimension() {
      return 5;
    }

    @Override
    public Component component(int index) {
      return pendulum.component(index);
    }

    @Override
    public void residual(double t, double[] y, double[] yDot, double[] residual) {
      pendulum.residual(t, y, yDot, residual);
    }

    @Override
    public boolean project(double t, double[] y) {
      double length = Math.sqrt(y[0] * y[0] + y[1] * y[1]);
      y[0] /= length;
      y[1] /= length;
      double along = y[0] * y[2] + y[1] * y[3];
      y[2] -= along * y[0];
      y[3] -= along * y[1];
      return true;
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-4, 1e-6, 1e-8, 1e-10})
  void projectedSolutionIsOnTheManifoldAndBetterThanADriftingOne(double tolerance) {
    Ode15sR integrator = integrator(tolerance);
    PendulumWithMultiplier pendulum = new PendulumWithMultiplier();
    double[] start = pendulum.reference().initialState();
    StepResult result =
        integrator.start(new Projected(), 0, start, pendulum.initialDerivative(), 10);
    double[] y = new double[5];
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
      integrator.interpolate(integrator.time(), y, new double[5]);
      for (var invariant : pendulum.invariants()) {
        assertThat(invariant.applyAsDouble(y)).isCloseTo(0, within(1e-14));
      }
    }
    assertThat(result).isEqualTo(StepResult.REACHED_END);
    double digits = pendulum.mixedDigits(y, pendulum.reference().atEnd());
    assertThat(digits).isGreaterThan(ResidualRun.of(pendulum, tolerance).digits());
  }

  @Test
  void algebraicComponentsDoNotTakePartInTheTests() {
    // z wiggles a thousand times as fast as y and is in no test.
    ImplicitOde wiggle =
        new ImplicitOde(
            2,
            (t, y, yDot, r) -> {
              r[0] = yDot[0] + y[0];
              r[1] = y[1] - StrictMath.sin(1000 * t);
            }) {
          @Override
          public Component component(int index) {
            return index == 1 ? Component.ALGEBRAIC : Component.DIFFERENTIAL;
          }
        };
    Ode15sR both = integrator(1e-6);
    Ode15sR alone = integrator(1e-6);
    finish(both, both.start(wiggle, 0, new double[] {1, 0}, new double[] {-1, 0}, 5));
    ImplicitOde decay = new ImplicitOde(1, (t, y, yDot, r) -> r[0] = yDot[0] + y[0]);
    finish(alone, alone.start(decay, 0, new double[] {1}, new double[] {-1}, 5));
    // A third of the tolerance at orders around 4: 3^(1/5) times the steps.
    assertThat(both.statistics().steps()).isLessThan(alone.statistics().steps() * 14 / 10);
    double[] y = Run.state(both, 5, 2);
    assertThat(y[1]).isCloseTo(StrictMath.sin(5000), within(1e-9));
  }

  private static void finish(Ode15sR integrator, StepResult started) {
    StepResult result = started;
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    assertThat(result).isEqualTo(StepResult.REACHED_END);
  }

  @Test
  void algebraicComponentThatIsNotFiniteIsNotAccepted() {
    ImplicitOde broken =
        new ImplicitOde(
            2,
            (t, y, yDot, r) -> {
              r[0] = yDot[0] + y[0];
              r[1] = y[1] - (t > 1 ? Double.POSITIVE_INFINITY : 0);
            }) {
          @Override
          public Component component(int index) {
            return index == 1 ? Component.ALGEBRAIC : Component.DIFFERENTIAL;
          }
        };
    Ode15sR integrator = integrator(1e-6);
    StepResult result = integrator.start(broken, 0, new double[] {1, 0}, new double[] {-1, 0}, 5);
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    assertThat(result).isEqualTo(StepResult.FAILED);
    assertThat(integrator.failure().cause()).isEqualTo(IntegrationFailure.Cause.NOT_FINITE);
    assertThat(integrator.failure().worstComponent()).isEqualTo(1);
    assertThat(integrator.failure().time()).isCloseTo(1, within(1e-9));
    assertThat(Run.state(integrator, integrator.time(), 2)[1]).isFinite();
  }

  // Derivatives known, and linear algebra of their own

  /** The pendulum with its derivatives, counting how often they are asked for. */
  private static class Known extends ImplicitOde implements ResidualJacobianSystem {
    private int asked;

    Known() {
      super(5, new PendulumWithMultiplier()::residual);
    }

    @Override
    public Component component(int index) {
      return index == 4 ? Component.ALGEBRAIC : Component.DIFFERENTIAL;
    }

    @Override
    public void jacobians(double t, double[] y, double[] yDot, double[] fy, double[] fyDot) {
      asked++;
      for (int i = 0; i < 4; i++) {
        fyDot[6 * i] = 1;
      }
      fyDot[22] = y[0];
      fyDot[23] = y[1];
      fy[2] = -1;
      fy[8] = -1;
      fy[10] = y[4];
      fy[14] = y[0];
      fy[16] = y[4];
      fy[19] = y[1];
      fy[20] = yDot[2];
      fy[21] = yDot[3];
      fy[22] = 2 * y[2];
      fy[23] = 2 * y[3];
    }
  }

  @Test
  void knownDerivativesSpareTheDifferences() {
    PendulumWithMultiplier pendulum = new PendulumWithMultiplier();
    Known known = new Known();
    Ode15sR integrator = integrator(1e-6);
    finish(
        integrator,
        integrator.start(
            known, 0, pendulum.reference().initialState(), pendulum.initialDerivative(), 10));
    IntegrationStatistics differenced = ResidualRun.of(pendulum, 1e-6).statistics();
    double steps = differenced.steps();
    assertThat((double) integrator.statistics().steps()).isCloseTo(steps, within(0.03 * steps));
    assertThat(integrator.statistics().jacobians()).isEqualTo(known.asked);
    // One evaluation per solution; two solutions of the start share three evaluations.
    assertThat(integrator.statistics().evaluations())
        .isEqualTo(integrator.statistics().solutions() + 1);
  }

  /** The same with its own linear algebra. */
  private static final class Own extends Known implements LinearisedSystem {
    private final LinearSolver solver = new DenseLu(5);
    private final double[] fy = new double[25];
    private final double[] fyDot = new double[25];
    private int singular;

    @Override
    public boolean linearise(double t, double[] y, double[] yDot) {
      Arrays.fill(fy, 0);
      Arrays.fill(fyDot, 0);
      jacobians(t, y, yDot, fy, fyDot);
      return true;
    }

    @Override
    public boolean factor(double hGamma) {
      double[] matrix = new double[25];
      Arrays.setAll(matrix, i -> hGamma * fy[i] + fyDot[i]);
      singular = solver.factor(matrix);
      return singular == LinearSolver.NONSINGULAR;
    }

    @Override
    public void solve(double[] r) {
      solver.solve(r);
    }

    @Override
    public int singularComponent() {
      return singular;
    }
  }

  @Test
  void ownLinearAlgebraTakesTheSameSteps() {
    PendulumWithMultiplier pendulum = new PendulumWithMultiplier();
    double[] start = pendulum.reference().initialState().clone();
    // The multiplier and the accelerations are to be found.
    Ode15sR known = integrator(1e-6);
    Ode15sR own = integrator(1e-6);
    start[4] = 7;
    finish(known, known.start(new Known(), 0, start, new double[5], 10));
    finish(own, own.start(new Own(), 0, start, new double[5], 10));
    double steps = known.statistics().steps();
    assertThat((double) own.statistics().steps()).isCloseTo(steps, within(0.03 * steps));
    double digits = pendulum.mixedDigits(Run.state(known, 10, 5), pendulum.reference().atEnd());
    assertThat(pendulum.mixedDigits(Run.state(own, 10, 5), pendulum.reference().atEnd()))
        .isGreaterThan(digits - 0.5);
  }

  // Interruption and memory

  @Test
  void stopDuringStartAndStepsIsTakenUpWithTheSameBits() {
    PendulumWithMultiplier pendulum = new PendulumWithMultiplier();
    AtomicInteger asked = new AtomicInteger();
    Ode15sR stopped =
        new Ode15sR(
            new IntegratorSettings(
                1e-6,
                List.of(1e-6),
                Double.POSITIVE_INFINITY,
                0,
                0,
                Long.MAX_VALUE,
                () -> asked.incrementAndGet() % 7 == 0));
    // Nothing is known of multiplier and accelerations: the start has to search.
    double[] start = {1, 0, 0, 0, 3};
    StepResult result = stopped.start(pendulum, 0, start, new double[5], 10);
    assertThat(result).isEqualTo(StepResult.STOPPED);
    while (result == StepResult.ADVANCED || result == StepResult.STOPPED) {
      result = stopped.step();
    }
    Ode15sR whole = ResidualRun.integrator(pendulum, 1e-6);
    finish(whole, whole.start(pendulum, 0, start, new double[5], 10));
    assertThat(Run.state(stopped, 10, 5)).isEqualTo(Run.state(whole, 10, 5));
    assertThat(stopped.statistics()).isEqualTo(whole.statistics());
  }

  @Test
  void restartAfterAnImpactFindsNewMultipliers() {
    // At the lowest point the velocity turns round: the multiplier stays, the motion mirrors.
    PendulumWithMultiplier pendulum = new PendulumWithMultiplier();
    Ode15sR integrator = integrator(1e-8);
    StepResult result =
        integrator.start(
            pendulum, 0, pendulum.reference().initialState(), pendulum.initialDerivative(), 2);
    while (result == StepResult.ADVANCED && Run.state(integrator, integrator.time(), 5)[0] > 0) {
      result = integrator.step();
    }
    double t = integrator.time();
    double[] y = Run.state(integrator, t, 5);
    y[2] = -y[2];
    y[3] = -y[3];
    y[4] = 0;
    result = integrator.restart(t, y);
    assertThat(result).isEqualTo(StepResult.ADVANCED);
    // λ = |v|² − g y, by the second derivative of the constraint.
    assertThat(Run.state(integrator, t, 5)[4])
        .isCloseTo((y[2] * y[2] + y[3] * y[3] - 9.81 * y[1]), within(1e-5));
    while (result == StepResult.ADVANCED && integrator.time() < 2 * t) {
      result = integrator.step();
    }
    // Back where it started after the same time.
    assertThat(Run.state(integrator, 2 * t, 5)[0]).isCloseTo(1, within(1e-5));
  }

  @Test
  void stepsAndJacobiansAllocateNothing() {
    PendulumWithMultiplier pendulum = new PendulumWithMultiplier();
    var threads =
        (com.sun.management.ThreadMXBean) java.lang.management.ManagementFactory.getThreadMXBean();
    Ode15sR integrator = ResidualRun.integrator(pendulum, 1e-6);
    long allocated = 0;
    // The first runs load classes; the last one is measured.
    for (int run = 0; run < 20; run++) {
      integrator.start(
          pendulum, 0, pendulum.reference().initialState(), pendulum.initialDerivative(), 10);
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
}
