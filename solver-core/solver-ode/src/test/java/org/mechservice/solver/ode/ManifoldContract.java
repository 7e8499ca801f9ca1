package org.mechservice.solver.ode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.LoopPendulum;
import org.mechservice.solver.ode.suite.Run;

/** What an integrator does with components that follow from others, manifolds and unit groups. */
public abstract class ManifoldContract {
  protected abstract Integrator create(IntegratorSettings settings);

  /** Returns how many tolerances the error of nine swings may have become. */
  protected double accumulation() {
    return 2000;
  }

  private Integrator create(double tolerance) {
    return create(new IntegratorSettings(tolerance, tolerance));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-4, 1e-6, 1e-8, 1e-10})
  void passiveComponentsFollowTheIndependentOnes(double tolerance) {
    LoopPendulum pendulum = new LoopPendulum();
    Integrator integrator = create(tolerance);
    integrator.start(pendulum, 0, LoopPendulum.start(), 10);
    double[] y = new double[4];
    StepResult result = StepResult.ADVANCED;
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
      double end = integrator.previousTime() + integrator.stepSize();
      if (Math.abs(end - integrator.time()) < 1e-12) { // DE steps past the end
        integrator.interpolate(integrator.time(), y, new double[4]);
        // Completed in closed form, so to round-off.
        assertThat(y[0] * y[0] + y[1] * y[1]).isCloseTo(1, within(1e-15));
        assertThat(y[0] * y[2] + y[1] * y[3]).isCloseTo(0, within(1e-14));
      }
    }
    assertThat(result).isEqualTo(StepResult.REACHED_END);
    integrator.interpolate(10, y, new double[4]);
    assertThat(pendulum.changes()).isGreaterThan(15);
    for (int i = 0; i < 4; i++) {
      // Nine swings: the error per step is multiplied by the number of steps and by the phase.
      assertThat(y[i]).isCloseTo(LoopPendulum.atTen()[i], within(accumulation() * tolerance));
    }
  }

  @Test
  void otherIndependentComponentsCostNeitherOrderNorStep() {
    LoopPendulum pendulum = new LoopPendulum();
    Integrator integrator = create(1e-9);
    integrator.start(pendulum, 0, LoopPendulum.start(), 10);
    int changes = 0;
    double shrink = 1;
    int lowest = Integer.MAX_VALUE;
    for (int i = 0; integrator.time() < 9; i++) {
      double before = integrator.stepSize();
      integrator.step();
      if (i > 60 && pendulum.changes() > changes) {
        integrator.step();
        shrink = Math.min(shrink, integrator.stepSize() / before);
        lowest = Math.min(lowest, integrator.order());
      }
      changes = pendulum.changes();
    }
    // A restart would be at order 1 with a thousandth of the step.
    assertThat(lowest).isGreaterThanOrEqualTo(4);
    assertThat(shrink).isGreaterThanOrEqualTo(0.2);
  }

  @Test
  void passiveComponentsDoNotTakePartInTheErrorTest() {
    // The second component follows from the first and wiggles a thousand times as fast.
    Wiggle wiggle = new Wiggle();
    long steps = Run.of(create(1e-6), wiggle, 0, new double[] {0, 0}, 10).statistics().steps();
    FunctionOde alone = new FunctionOde(1, (t, y, yDot) -> yDot[0] = StrictMath.cos(t));
    long alone1 = Run.of(create(1e-6), alone, 0, new double[] {0}, 10).statistics().steps();
    assertThat(steps).isEqualTo(alone1);
  }

  private static final class Wiggle implements OdeSystem, CompletedSystem {
    @Override
    public int dimension() {
      return 2;
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {
      yDot[0] = StrictMath.cos(t);
      yDot[1] = 1000 * StrictMath.cos(1000 * y[0]) * yDot[0];
    }

    @Override
    public boolean independent(int component) {
      return component == 0;
    }

    @Override
    public boolean complete(double t, double[] y) {
      y[1] = StrictMath.sin(1000 * y[0]);
      return true;
    }

    @Override
    public boolean accepted(double t, double[] y) {
      return false;
    }
  }

  @Test
  void initialStateIsCompleted() {
    Integrator integrator = create(1e-6);
    double[] y0 = {0.7, -0.6, 0, 0};
    integrator.start(new LoopPendulum(), 0, y0, 1);
    double[] y = new double[4];
    integrator.interpolate(0, y, new double[4]);
    assertThat(y).containsExactly(new double[] {0.8, -0.6, 0, 0}, within(1e-15));
    assertThat(y0).containsExactly(0.7, -0.6, 0, 0);
  }

  @Test
  void stateThatCannotBeCompletedAnyMoreEndsTheRunThere() {
    LoopPendulum pendulum =
        new LoopPendulum() {
          @Override
          public boolean complete(double t, double[] y) {
            return t <= 0.5 && super.complete(t, y);
          }
        };
    Run run = Run.of(create(1e-6), pendulum, 0, LoopPendulum.start(), 10);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    assertThat(run.integrator().failure().cause())
        .isEqualTo(IntegrationFailure.Cause.NOT_COMPLETED);
    assertThat(run.integrator().failure().time()).isCloseTo(0.5, within(1e-12));
    assertThat(run.integrator().failure().worstComponent()).isEqualTo(-1);
  }

  @Test
  void initialStateThatCannotBeCompletedIsReported() {
    Run run = Run.of(create(1e-6), new LoopPendulum(), 0, new double[] {0, 2, 0, 0}, 10);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    assertThat(run.integrator().failure().cause())
        .isEqualTo(IntegrationFailure.Cause.NOT_COMPLETED);
  }

  // Projection

  /** The same mass with both coordinates integrated, moved radially back onto the circle. */
  private static final class ProjectedPendulum implements OdeSystem, ProjectedSystem {
    private final LoopPendulum equations = new LoopPendulum();

    @Override
    public int dimension() {
      return 4;
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {
      equations.derivative(t, y, yDot);
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
  void projectedSolutionIsOnTheManifoldAtEveryStep(double tolerance) {
    Integrator integrator = create(tolerance);
    integrator.start(new ProjectedPendulum(), 0, LoopPendulum.start(), 10);
    double[] y = new double[4];
    while (integrator.step() == StepResult.ADVANCED) {
      integrator.interpolate(integrator.time(), y, new double[4]);
      assertThat(defect(y)).isLessThan(1e-14);
    }
    LoopPendulum equations = new LoopPendulum();
    FunctionOde free = new FunctionOde(4, equations::derivative);
    double[] drifted = Run.of(create(tolerance), free, 0, LoopPendulum.start(), 10).atEnd();
    assertThat(defect(drifted)).isGreaterThan(0.01 * tolerance);
  }

  @Test
  void projectionCostsNoAccuracy() {
    LoopPendulum equations = new LoopPendulum();
    FunctionOde free = new FunctionOde(4, equations::derivative);
    double digitsLost = 0;
    for (int k = 4; k <= 10; k++) {
      double tolerance = StrictMath.pow(10, -k);
      double[] projected =
          Run.of(create(tolerance), new ProjectedPendulum(), 0, LoopPendulum.start(), 10).atEnd();
      double[] drifted = Run.of(create(tolerance), free, 0, LoopPendulum.start(), 10).atEnd();
      digitsLost += StrictMath.log10(error(projected) / error(drifted));
    }
    // On the average of seven tolerances; a single run is right by luck now and then.
    assertThat(digitsLost / 7).isLessThan(0.2);
  }

  private static double defect(double[] y) {
    return Math.max(Math.abs(y[0] * y[0] + y[1] * y[1] - 1), Math.abs(y[0] * y[2] + y[1] * y[3]));
  }

  private static double error(double[] y) {
    double error = 0;
    for (int i = 0; i < 4; i++) {
      error = Math.max(error, Math.abs(y[i] - LoopPendulum.atTen()[i]));
    }
    return error;
  }

  // Groups of norm one

  /** Euler parameters of a body that turns about a wandering axis; e' = ½ (0, ω) ∘ e. */
  private static class Turning implements OdeSystem, ErrorWeightGroups {
    @Override
    public int dimension() {
      return 4;
    }

    @Override
    public int groupCount() {
      return 1;
    }

    @Override
    public int groupStart(int group) {
      return 0;
    }

    @Override
    public int groupSize(int group) {
      return 4;
    }

    @Override
    public void derivative(double t, double[] e, double[] eDot) {
      double wx = 3 * StrictMath.cos(t);
      double wy = 2;
      double wz = 5 * StrictMath.sin(0.7 * t);
      eDot[0] = 0.5 * (-wx * e[1] - wy * e[2] - wz * e[3]);
      eDot[1] = 0.5 * (wx * e[0] + wy * e[3] - wz * e[2]);
      eDot[2] = 0.5 * (wy * e[0] + wz * e[1] - wx * e[3]);
      eDot[3] = 0.5 * (wz * e[0] + wx * e[2] - wy * e[1]);
    }
  }

  private static final class TurningKeptAtNormOne extends Turning implements UnitNormGroups {}

  @Test
  void unitGroupIsScaledBackWithoutChangingItsDirectionOrTheSteps() {
    double[] start = {1, 0, 0, 0};
    Run kept = Run.of(create(1e-5), new TurningKeptAtNormOne(), 0, start, 50);
    Run free = Run.of(create(1e-5), new Turning(), 0, start, 50);
    double drift = norm(free.atEnd()) - 1;
    assertThat(Math.abs(drift)).isGreaterThan(100 * UnitNormGroups.NORM_DRIFT);
    // What one step can add to the drift allowed before it.
    assertThat(norm(kept.atEnd())).isCloseTo(1, within(1e-6));
    for (int i = 0; i < 4; i++) {
      // Only the weights differ, by the drift.
      assertThat(kept.atEnd()[i] / norm(kept.atEnd()))
          .isCloseTo(free.atEnd()[i] / norm(free.atEnd()), within(2 * Math.abs(drift)));
    }
    double steps = free.statistics().steps();
    assertThat((double) kept.statistics().steps()).isCloseTo(steps, within(0.02 * steps));
  }

  private static double norm(double[] e) {
    return Math.sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3]);
  }
}
