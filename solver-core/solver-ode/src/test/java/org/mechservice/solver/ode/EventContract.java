package org.mechservice.solver.ode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.events.EventFunctions.Direction;
import org.mechservice.solver.ode.events.EventFunctions.Reaction;
import org.mechservice.solver.ode.events.EventIntegration;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.LoopPendulum;
import org.mechservice.solver.ode.suite.Run;

/**
 * Events, whatever the integrator: what they lead to, and their {@linkplain EventLocationContract
 * location}.
 */
public abstract class EventContract extends EventLocationContract {
  // The suite's bouncing ball

  @ParameterizedTest
  @EnumSource(names = {"STANDARD", "STRICT"})
  void ballBouncesWhenItShouldAndNoOftener(Mode mode) {
    // Suite: ev_bounce. Dropped from 10 m, keeping 80 % of its speed.
    Bounces bounces = new Bounces(0.8);
    IntegratorSettings settings = new IntegratorSettings(1e-10, 1e-10).withMode(mode);
    EventIntegration integrator = new EventIntegration(create(settings), bounces);
    double[] y = new double[2];
    StepResult result = integrator.start(FALL, 0, new double[] {10, 0}, 12);
    double lowest = 10;
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
      for (double part : new double[] {0, 0.5, 1}) {
        double t =
            integrator.previousTime() + part * (integrator.time() - integrator.previousTime());
        integrator.interpolate(part == 1 ? Math.min(12, integrator.time()) : t, y, new double[2]);
        lowest = Math.min(lowest, y[0]);
      }
    }
    assertThat(result).isEqualTo(StepResult.REACHED_END);
    List<Double> expected = new ArrayList<>();
    double fall = Math.sqrt(2 * 10 / GRAVITY);
    double t = fall;
    for (double flight = 2 * fall * 0.8; t < 12; flight *= 0.8) {
      expected.add(t);
      t += flight;
    }
    assertThat(expected).hasSize(12);
    assertThat(bounces.times).hasSize(12);
    for (int i = 0; i < 12; i++) {
      assertThat(bounces.times.get(i)).isCloseTo(expected.get(i), within(1e-9));
    }
    assertThat(lowest).isGreaterThanOrEqualTo(-1e-8);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8})
  void ballWhoseWeightFallsWithHeightBouncesOnceAtEachContact(double tolerance) {
    // y'' = ω² (y − 1), ω = 10 1/s, let go from y = 1/2: it comes down with ω √3 / 2 and goes up as
    // fast, for 2 artanh(√3 / 2) / ω. The slope of its weight turns the dense output of a first
    // step
    // downwards at its very beginning.
    double omega = 10;
    Bounces bounces = new Bounces(1);
    FunctionOde pressed =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = y[1];
              yDot[1] = omega * omega * (y[0] - 1);
            });
    run(new EventIntegration(create(tolerance), bounces), pressed, new double[] {0.5, 0}, 2);
    double r = Math.sqrt(3) / 2;
    double flight = Math.log((1 + r) / (1 - r)) / omega;
    // 2 s hold half a flight and seven whole ones.
    assertThat(bounces.times).hasSizeGreaterThan(4);
    for (int i = 1; i < bounces.times.size(); i++) {
      double apart = bounces.times.get(i) - bounces.times.get(i - 1);
      assertThat(apart).as("flight %d", i).isBetween(0.5 * flight, 1.5 * flight);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-6, 1e-10})
  void bouncesThatAccumulateEndTheRun(double tolerance) {
    EventIntegration integrator = new EventIntegration(create(tolerance), new Bounces(0.8));
    Run run = run(integrator, FALL, new double[] {10, 0}, 20);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    IntegrationFailure failure = integrator.failure();
    assertThat(failure.cause()).isEqualTo(IntegrationFailure.Cause.EVENTS_ACCUMULATE);
    // All bounces together take (1 + 2 · 0.8 / 0.2) times the first fall. Bounces lower than the
    // tolerance, each shorter than √(8 tolerance / g), need not be there; five times the last one
    // that is are to come.
    double rest = 9 * Math.sqrt(2 * 10 / GRAVITY);
    assertThat(failure.time()).isCloseTo(rest, within(20 * Math.sqrt(tolerance)));
    assertThat(failure.lastSteps()).hasSize(10);
    assertThatIllegalStateException().isThrownBy(integrator::step);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.01, 0.2, 0.5})
  void ballThatComesToRestDoesNotSlipThroughTheFloor(double restitution) {
    for (double tolerance : new double[] {1e-3, 1e-6, 1e-8}) {
      EventIntegration integrator =
          new EventIntegration(create(tolerance), new Bounces(restitution));
      Run run = run(integrator, FALL, new double[] {10, 0}, 20);
      assertThat(run.result()).as("tolerance %s", tolerance).isEqualTo(StepResult.FAILED);
      assertThat(integrator.failure().cause())
          .isEqualTo(IntegrationFailure.Cause.EVENTS_ACCUMULATE);
      assertThat(run.atEnd()[0]).isGreaterThan(-1e-8);
    }
  }

  @Test
  void functionThatAChangeOfTheStateTakesToTheOtherSideHasItsEvent() {
    // Moved from above the floor to below it at t = 1; the floor is to end the run.
    boolean[] jumped = {false};
    Watch floor =
        new Watch(
            2,
            Direction.FALLING,
            Reaction.RESTART,
            (t, y, g) -> {
              g[0] = 1 - t;
              g[1] = y[0];
            }) {
          @Override
          public Reaction occurred(double t, double[] y, boolean[] occurred) {
            super.occurred(t, y, occurred);
            if (occurred[1]) {
              return Reaction.STOP;
            }
            jumped[0] = true;
            y[0] = -3;
            return Reaction.RESTART;
          }
        };
    EventIntegration integrator = new EventIntegration(create(1e-6), floor);
    StepResult result = integrator.start(FALL, 0, new double[] {10, 0}, 20);
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    assertThat(jumped[0]).isTrue();
    assertThat(result).isEqualTo(StepResult.REACHED_END);
    assertThat(floor.functions).containsExactly(List.of(0), List.of(1));
    assertThat(integrator.time()).isCloseTo(1, within(1e-9));
  }

  @Test
  void functionThatRestsAtZeroAfterItsEventMayLeaveItOnEitherSideLater() {
    // A block stops by friction at t = 1, rests, and slides on from t = 2.
    boolean[] slides = {true};
    FunctionOde block =
        new FunctionOde(
            1, (t, y, yDot) -> yDot[0] = slides[0] ? -1 : -Math.pow(Math.max(0, t - 2), 2));
    Watch halt =
        new Watch(1, Direction.FALLING, Reaction.RESTART, (t, y, g) -> g[0] = y[0]) {
          @Override
          public Reaction occurred(double t, double[] y, boolean[] occurred) {
            slides[0] = false;
            y[0] = 0;
            return super.occurred(t, y, occurred);
          }
        };
    Run run = run(new EventIntegration(create(1e-6), halt), block, new double[] {1}, 3);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(halt.times).hasSize(1);
  }

  @Test
  void switchWithoutPlayThatActsBackOnItselfEndsTheRun() {
    // y' = −mode, and crossing 0 in either direction makes mode the sign of y.
    double[] mode = {1};
    FunctionOde relay = new FunctionOde(1, (t, y, yDot) -> yDot[0] = -mode[0]);
    Watch thrown =
        new Watch(1, Direction.EITHER, Reaction.RESTART, (t, y, g) -> g[0] = y[0]) {
          @Override
          public Reaction occurred(double t, double[] y, boolean[] occurred) {
            mode[0] = -mode[0];
            return super.occurred(t, y, occurred);
          }
        };
    EventIntegration integrator = new EventIntegration(create(1e-6), thrown);
    Run run = run(integrator, relay, new double[] {1}, 3);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    assertThat(integrator.failure().cause()).isEqualTo(IntegrationFailure.Cause.EVENTS_ACCUMULATE);
    assertThat(integrator.failure().time()).isCloseTo(1, within(1e-6));
    assertThat(Math.abs(run.atEnd()[0])).isLessThan(1e-6);
  }

  @Test
  void switchWithPlayGoesOn() {
    double[] mode = {1};
    FunctionOde relay = new FunctionOde(1, (t, y, yDot) -> yDot[0] = -mode[0]);
    Watch thrown =
        new Watch(
            2,
            Direction.FALLING,
            Reaction.RESTART,
            (t, y, g) -> {
              g[0] = y[0] + 0.1;
              g[1] = 0.1 - y[0];
            }) {
          @Override
          public Reaction occurred(double t, double[] y, boolean[] occurred) {
            mode[0] = occurred[0] ? -1 : 1;
            return super.occurred(t, y, occurred);
          }
        };
    Run run = run(new EventIntegration(create(1e-6), thrown), relay, new double[] {1}, 10);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    // From 1 to −0.1, then to and fro over 0.2 until t = 10.
    assertThat(thrown.times).hasSize(1 + 44);
    assertThat(run.atEnd()[0]).isCloseTo(0, within(0.1 + 1e-9));
  }

  @Test
  void changeOfTheStateAtTheEndNeedsNoValuesBehindIt() {
    class UntilTwo implements OdeSystem, PiecewiseSystem {
      @Override
      public int dimension() {
        return 1;
      }

      @Override
      public void derivative(double t, double[] y, double[] yDot) {
        yDot[0] = t > 2 ? Double.NaN : 1;
      }

      @Override
      public List<Double> breakpoints() {
        return List.of(2.0);
      }
    }
    Watch last =
        new Watch(1, Direction.RISING, Reaction.RESTART, (t, y, g) -> g[0] = t - 2) {
          @Override
          public Reaction occurred(double t, double[] y, boolean[] occurred) {
            y[0] = 0;
            return super.occurred(t, y, occurred);
          }
        };
    EventIntegration integrator = new EventIntegration(create(TENTH), last);
    Run run = run(integrator, new UntilTwo(), new double[] {0}, 2);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(last.times).containsExactly(2.0);
  }

  // Restart

  @Test
  void restartBeginsAtOrderOneAndTheCountersGoOn() {
    Bounces bounces = new Bounces(0.8);
    EventIntegration integrator = new EventIntegration(create(1e-8), bounces);
    integrator.start(FALL, 0, new double[] {10, 0}, 12);
    while (bounces.times.isEmpty()) {
      integrator.step();
    }
    long steps = integrator.statistics().steps();
    long evaluations = integrator.statistics().evaluations();
    assertThat(integrator.time()).isEqualTo(bounces.times.get(0));
    assertThat(integrator.events()).isEqualTo(1);
    assertThat(integrator.occurred(0)).isTrue();
    integrator.step();
    assertThat(integrator.order()).isEqualTo(1);
    assertThat(integrator.previousTime()).isEqualTo(bounces.times.get(0));
    assertThat(integrator.statistics().steps()).isEqualTo(steps + 1);
    assertThat(integrator.statistics().evaluations()).isGreaterThan(evaluations);
    // The first step is the method's own, not the one before the bounce.
    assertThat(integrator.stepSize()).isLessThan(0.1);
  }

  @Test
  void solutionThatLedToTheEventCanBeInterpolatedUntilTheNextStep() {
    Bounces bounces = new Bounces(0.8);
    EventIntegration integrator = new EventIntegration(create(1e-8), bounces);
    integrator.start(FALL, 0, new double[] {10, 0}, 12);
    while (bounces.times.isEmpty()) {
      integrator.step();
    }
    double t = integrator.time();
    double[] before = Run.state(integrator, t, 2);
    assertThat(before[1]).isCloseTo(-GRAVITY * t, within(1e-6));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Run.state(integrator, Math.nextUp(t), 2))
        .withMessageContaining("event");
    integrator.step();
    assertThat(Run.state(integrator, t, 2)[1]).isCloseTo(0.8 * GRAVITY * t, within(1e-6));
  }

  @Test
  void watchingChangesNothing() {
    Watch zeros = new Watch(1, Direction.EITHER, Reaction.CONTINUE, (t, y, g) -> g[0] = y[0] - 0.5);
    Run watched = run(new EventIntegration(create(1e-8), zeros), CIRCLE, new double[] {0, 1}, 20);
    Run alone = Run.of(create(1e-8), CIRCLE, 0, new double[] {0, 1}, 20);
    assertThat(watched.atEnd()).isEqualTo(alone.atEnd());
    assertThat(watched.statistics()).isEqualTo(alone.statistics());
  }

  @Test
  void restartByHandForgetsTheHistoryAndGoesOnFromTheGivenState() {
    Integrator integrator = create(1e-8);
    integrator.start(CIRCLE, 0, new double[] {0, 1}, 10);
    while (integrator.time() < 3) {
      integrator.step();
    }
    double middle = integrator.previousTime() + 0.5 * integrator.stepSize();
    assertThat(integrator.restart(middle, new double[] {0, 1})).isEqualTo(StepResult.ADVANCED);
    assertThat(integrator.time()).isEqualTo(middle);
    assertThat(integrator.order()).isZero();
    assertThat(Run.state(integrator, middle, 2)).containsExactly(0, 1);
    integrator.step();
    assertThat(integrator.order()).isEqualTo(1);
    StepResult result = StepResult.ADVANCED;
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    assertThat(Run.state(integrator, 10, 2)[0])
        .isCloseTo(StrictMath.sin(10 - middle), within(1e-5));
  }

  @Test
  void restartOutsideTheLastStepIsRefused() {
    Integrator integrator = create(1e-8);
    integrator.start(CIRCLE, 0, new double[] {0, 1}, 10);
    integrator.step();
    double beyond = integrator.time() + 1;
    assertThatIllegalArgumentException()
        .isThrownBy(() -> integrator.restart(beyond, new double[] {0, 1}))
        .withMessageContaining(Double.toString(beyond));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> integrator.restart(integrator.time(), new double[] {0, Double.NaN}))
        .withMessageContaining("component 1 is NaN");
  }

  // Other problems

  @Test
  void eventFunctionThatIsNotFiniteEndsTheRun() {
    Watch broken =
        new Watch(1, Direction.EITHER, Reaction.CONTINUE, (t, y, g) -> g[0] = Math.sqrt(3 - t) + 1);
    EventIntegration integrator = new EventIntegration(create(1e-6), broken);
    Run run = run(integrator, CIRCLE, new double[] {0, 1}, 10);
    assertThat(run.result()).isEqualTo(StepResult.FAILED);
    assertThat(integrator.failure().cause()).isEqualTo(IntegrationFailure.Cause.EVENT_NOT_FINITE);
  }

  @Test
  void functionsSeeCompletedStates() {
    // The rod's length is 1 in every completed state, and 1e-4 off in interpolated ones.
    Watch length =
        new Watch(
            2,
            Direction.EITHER,
            Reaction.CONTINUE,
            (t, y, g) -> {
              assertThat(y[0] * y[0] + y[1] * y[1]).isCloseTo(1, within(1e-14));
              g[0] = y[0];
              g[1] = 1;
            });
    run(new EventIntegration(create(1e-4), length), new LoopPendulum(), LoopPendulum.start(), 3);
    assertThat(length.times).isNotEmpty();
  }
}
