package org.mechservice.solver.ode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.events.EventFunctions;
import org.mechservice.solver.ode.events.EventFunctions.Direction;
import org.mechservice.solver.ode.events.EventFunctions.NoEvent;
import org.mechservice.solver.ode.events.EventFunctions.Reaction;
import org.mechservice.solver.ode.events.EventIntegration;
import org.mechservice.solver.ode.events.EventSearch;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.Run;

/** Where events are found, and which, whatever the integrator. */
public abstract class EventLocationContract {
  static final double GRAVITY = 9.81;

  /** y'' = −y from (0, 1): sin t, cos t. */
  static final FunctionOde CIRCLE =
      new FunctionOde(
          2,
          (t, y, yDot) -> {
            yDot[0] = y[1];
            yDot[1] = -y[0];
          });

  /** Steps of at most 0.1. */
  static final IntegratorSettings TENTH =
      new IntegratorSettings(1e-6, List.of(1e-6), 0.1, 0, 0, Long.MAX_VALUE, () -> false);

  static final FunctionOde FALL =
      new FunctionOde(
          2,
          (t, y, yDot) -> {
            yDot[0] = y[1];
            yDot[1] = -GRAVITY;
          });

  protected abstract Integrator create(IntegratorSettings settings);

  protected final Integrator create(double tolerance) {
    return create(new IntegratorSettings(tolerance, tolerance));
  }

  /** Functions written down in a test, with a record of what occurred. */
  static class Watch implements EventFunctions {
    final List<Double> times = new ArrayList<>();
    final List<List<Integer>> functions = new ArrayList<>();
    private final int count;
    private final Values values;
    private final Direction direction;
    private final Reaction reaction;
    final List<Double> touches = new ArrayList<>();
    final List<Double> poles = new ArrayList<>();
    final List<NoEvent> atStart = new ArrayList<>();
    private double hysteresis;
    private double resolution = 1e-9;

    interface Values {
      void evaluate(double t, double[] y, double[] g);
    }

    Watch(int count, Direction direction, Reaction reaction, Values values) {
      this.count = count;
      this.direction = direction;
      this.reaction = reaction;
      this.values = values;
    }

    Watch withHysteresis(double band) {
      hysteresis = band;
      return this;
    }

    Watch withResolution(double part) {
      resolution = part;
      return this;
    }

    @Override
    public double resolution() {
      return resolution;
    }

    @Override
    public void noEvent(int function, NoEvent why, double t, double value) {
      switch (why) {
        case TOUCH -> touches.add(t);
        case POLE -> poles.add(t);
        case ZERO_AT_START, PASSED_AT_START -> atStart.add(why);
      }
    }

    @Override
    public int count() {
      return count;
    }

    @Override
    public void evaluate(double t, double[] y, double[] g) {
      values.evaluate(t, y, g);
    }

    @Override
    public Direction direction(int function) {
      return direction;
    }

    @Override
    public double hysteresis(int function) {
      return hysteresis;
    }

    @Override
    public Reaction occurred(double t, double[] y, boolean[] occurred) {
      times.add(t);
      List<Integer> which = new ArrayList<>();
      for (int i = 0; i < occurred.length; i++) {
        if (occurred[i]) {
          which.add(i);
        }
      }
      functions.add(which);
      return reaction;
    }
  }

  /** A ball that keeps a share of its speed at each bounce. */
  static final class Bounces extends Watch {
    private final double restitution;

    Bounces(double restitution) {
      super(1, Direction.FALLING, Reaction.RESTART, (t, y, g) -> g[0] = y[0]);
      this.restitution = restitution;
    }

    @Override
    public Reaction occurred(double t, double[] y, boolean[] occurred) {
      y[1] = -restitution * y[1];
      return super.occurred(t, y, occurred);
    }
  }

  static Run run(EventIntegration integrator, OdeSystem system, double[] y0, double tEnd) {
    return Run.of(integrator, system, 0, y0, tEnd);
  }

  // Location

  @ParameterizedTest
  @EnumSource(Direction.class)
  void zerosOfTheLookedForDirectionAreFound(Direction direction) {
    Watch zeros = new Watch(1, direction, Reaction.CONTINUE, (t, y, g) -> g[0] = y[0] - 0.5);
    run(new EventIntegration(create(1e-10), zeros), CIRCLE, new double[] {0, 1}, 20);
    List<Double> expected = new ArrayList<>();
    for (int turn = 0; turn < 4; turn++) {
      double first = StrictMath.asin(0.5) + 2 * Math.PI * turn;
      double second = Math.PI - StrictMath.asin(0.5) + 2 * Math.PI * turn;
      if (direction != Direction.FALLING && first < 20) {
        expected.add(first);
      }
      if (direction != Direction.RISING && second < 20) {
        expected.add(second);
      }
    }
    assertThat(zeros.times).hasSameSizeAs(expected);
    for (int i = 0; i < expected.size(); i++) {
      assertThat(zeros.times.get(i)).isCloseTo(expected.get(i), within(1e-7));
    }
  }

  @Test
  void zeroOfTheInterpolatedSolutionIsLocatedToRoundOff() {
    Watch zeros = new Watch(1, Direction.EITHER, Reaction.STOP, (t, y, g) -> g[0] = y[0] - 0.5);
    EventIntegration integrator = new EventIntegration(create(TENTH), zeros);
    integrator.start(CIRCLE, 0, new double[] {0, 1}, 20);
    StepResult result = StepResult.ADVANCED;
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    assertThat(result).isEqualTo(StepResult.REACHED_END);
    double t = integrator.time();
    double[] y = Run.state(integrator, t, 2);
    double width = EventSearch.width(t, 0.1);
    // |g| at the place reported: the slope is 0.87, and y is known to round-off.
    assertThat(y[0] - 0.5).isBetween(0.0, width + 4 * Math.ulp(0.5));
  }

  @Test
  void eventsOfFunctionsThatVanishTogetherAreReportedTogether() {
    Watch zeros =
        new Watch(
            3,
            Direction.EITHER,
            Reaction.CONTINUE,
            (t, y, g) -> {
              g[0] = y[0] - 0.5;
              g[1] = 7 * (0.5 - y[0]);
              g[2] = y[1];
            });
    run(new EventIntegration(create(1e-8), zeros), CIRCLE, new double[] {0, 1}, 3);
    assertThat(zeros.functions).containsExactly(List.of(0, 1), List.of(2), List.of(0, 1));
  }

  @Test
  void eventsInsideOneStepComeInTheirOrder() {
    // A constant solution takes steps of a tenth of the interval: three zeros in the second one.
    FunctionOde still = new FunctionOde(1, (t, y, yDot) -> yDot[0] = 0);
    Watch zeros =
        new Watch(
            3,
            Direction.EITHER,
            Reaction.CONTINUE,
            (t, y, g) -> {
              g[0] = t - 0.17;
              g[1] = t - 0.13;
              g[2] = (t - 0.15) * (t - 0.15) * (t - 0.15);
            });
    run(new EventIntegration(create(1e-6), zeros), still, new double[] {1}, 1);
    assertThat(zeros.functions).containsExactly(List.of(1), List.of(2), List.of(0));
    assertThat(zeros.times.get(0)).isCloseTo(0.13, within(1e-13));
    assertThat(zeros.times.get(1)).isCloseTo(0.15, within(1e-13));
    assertThat(zeros.times.get(2)).isCloseTo(0.17, within(1e-13));
  }

  @Test
  void twoZerosOfAFunctionInsideOneLongStepAreBothFound() {
    FunctionOde still = new FunctionOde(1, (t, y, yDot) -> yDot[0] = 0);
    Watch zeros =
        new Watch(
            1, Direction.EITHER, Reaction.CONTINUE, (t, y, g) -> g[0] = (t - 0.52) * (t - 0.57));
    run(new EventIntegration(create(TENTH), zeros), still, new double[] {1}, 1);
    assertThat(zeros.times).hasSize(2);
  }

  @Test
  void functionThatIsZeroAtTheStartHasNoEventThere() {
    Watch zeros = new Watch(1, Direction.EITHER, Reaction.CONTINUE, (t, y, g) -> g[0] = y[0]);
    run(new EventIntegration(create(1e-8), zeros), CIRCLE, new double[] {0, 1}, 4);
    assertThat(zeros.times).hasSize(1);
    assertThat(zeros.times.get(0)).isCloseTo(Math.PI, within(1e-6));
  }

  @Test
  void functionThatIsZeroAllTheTimeHasNoEvent() {
    Watch zeros = new Watch(1, Direction.EITHER, Reaction.CONTINUE, (t, y, g) -> g[0] = 0);
    run(new EventIntegration(create(1e-8), zeros), CIRCLE, new double[] {0, 1}, 4);
    assertThat(zeros.times).isEmpty();
  }

  @Test
  void wiggleInsideTheHysteresisIsOneEvent() {
    // Crosses 0 many times near t = 1, never farther than 0.02 on the way.
    Watch.Values wiggle = (t, y, g) -> g[0] = t - 1 + 0.02 * StrictMath.sin(200 * t);
    FunctionOde still = new FunctionOde(1, (t, y, yDot) -> yDot[0] = 0);
    IntegratorSettings fine =
        new IntegratorSettings(1e-6, List.of(1e-6), 1e-3, 0, 0, Long.MAX_VALUE, () -> false);
    Watch all = new Watch(1, Direction.EITHER, Reaction.CONTINUE, wiggle);
    run(new EventIntegration(create(fine), all), still, new double[] {1}, 2);
    assertThat(all.times).hasSizeGreaterThan(2);
    Watch one = new Watch(1, Direction.EITHER, Reaction.CONTINUE, wiggle).withHysteresis(0.045);
    run(new EventIntegration(create(fine), one), still, new double[] {1}, 2);
    assertThat(one.times).hasSize(1);
  }

  @Test
  void eventsAreFoundBackwardsInTime() {
    Watch zeros = new Watch(1, Direction.EITHER, Reaction.CONTINUE, (t, y, g) -> g[0] = y[0] - 0.5);
    Run.of(new EventIntegration(create(1e-10), zeros), CIRCLE, 0, new double[] {0, 1}, -8);
    assertThat(zeros.times).hasSize(2);
    assertThat(zeros.times.get(0)).isCloseTo(-Math.PI - Math.PI / 6, within(1e-7));
    assertThat(zeros.times.get(1)).isCloseTo(-2 * Math.PI + Math.PI / 6, within(1e-7));
  }

  /** Two zeros 3 ms apart at the top of a flight of 2 s, seen because the top is looked for. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-6, 1e-9})
  void functionThatOnlyJustCrossesZeroIsSeenIfItsRateIsWatchedBesideIt(double tolerance) {
    double over = 1e-6;
    FunctionOde flight =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = y[1];
              yDot[1] = -1;
            });
    Watch level =
        new Watch(
            2,
            Direction.EITHER,
            Reaction.CONTINUE,
            (t, y, g) -> {
              g[0] = y[0] - (0.5 - over);
              g[1] = y[1];
            });
    run(new EventIntegration(create(tolerance), level), flight, new double[] {0, 1}, 2);
    assertThat(level.functions).containsExactly(List.of(0), List.of(1), List.of(0));
    // An error of the height is as much longer in time as the flight is slow there.
    double speed = Math.sqrt(2 * over);
    assertThat(level.times.get(0)).isCloseTo(1 - speed, within(tolerance / speed));
    assertThat(level.times.get(1)).isCloseTo(1, within(10 * tolerance));
    assertThat(level.times.get(2)).isCloseTo(1 + speed, within(tolerance / speed));
  }

  // Zero without an event, and events that look like none

  /** The time itself: y' = 1 from 0, in steps of at most 0.1. */
  private Watch watchTime(Direction direction, Watch.Values values, double tEnd) {
    FunctionOde time = new FunctionOde(1, (t, y, yDot) -> yDot[0] = 1);
    Watch watch = new Watch(1, direction, Reaction.CONTINUE, values);
    run(new EventIntegration(create(TENTH), watch), time, new double[] {0}, tEnd);
    return watch;
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.013, 0.31, 0.5, 1.777})
  void functionThatRestsAtZeroHasItsEventWhereItLeavesZero(double leaves) {
    List<Watch.Values> rises =
        List.of(
            (t, y, g) -> g[0] = Math.max(0, y[0] - leaves),
            (t, y, g) -> g[0] = y[0] < leaves ? 0 : 1,
            (t, y, g) -> g[0] = 1e-9 * Math.max(0, y[0] - leaves));
    for (Watch.Values rise : rises) {
      for (Direction direction : List.of(Direction.RISING, Direction.EITHER)) {
        Watch watch = watchTime(direction, rise, 2);
        assertThat(watch.times).hasSize(1);
        assertThat(watch.times.get(0)).isCloseTo(leaves, within(1e-9));
        assertThat(watch.atStart).isEmpty();
      }
      assertThat(watchTime(Direction.FALLING, rise, 2).times).isEmpty();
      Watch falls = watchTime(Direction.FALLING, (t, y, g) -> negated(rise, t, y, g), 2);
      assertThat(falls.times).hasSize(1);
      assertThat(falls.times.get(0)).isCloseTo(leaves, within(1e-9));
    }
  }

  private static void negated(Watch.Values values, double t, double[] y, double[] g) {
    values.evaluate(t, y, g);
    g[0] = -g[0];
  }

  @Test
  void functionThatReturnsToFlatZeroAndRisesAgainHasAnEventEachTime() {
    Watch watch = watchTime(Direction.RISING, (t, y, g) -> g[0] = Math.max(0, hill(y[0])), 4);
    assertThat(watch.times).hasSize(2);
    assertThat(watch.times.get(0)).isCloseTo(0.6, within(1e-9));
    assertThat(watch.times.get(1)).isCloseTo(2.6, within(1e-9));
  }

  /** Above zero from 0.6 to 1.4 and from 2.6 to 3.4. */
  private static double hill(double x) {
    return 0.4 - Math.abs(x - 2 * Math.floor(x / 2) - 1);
  }

  @Test
  void ballLetGoExactlyAtTheLevelLeavesItWithoutAnEvent() {
    // The height differs from the level by rounding only at first: zero, but not at rest there.
    for (double level : new double[] {0, 5, 123.456}) {
      Watch watch =
          new Watch(1, Direction.FALLING, Reaction.CONTINUE, (t, y, g) -> g[0] = y[0] - level);
      run(new EventIntegration(create(1e-8), watch), FALL, new double[] {level, 0}, 1);
      assertThat(watch.times).as("level %s", level).isEmpty();
      assertThat(watch.atStart).as("level %s", level).containsExactly(NoEvent.ZERO_AT_START);
    }
  }

  @Test
  void functionBeyondZeroAtTheStartIsTold() {
    for (double sign : new double[] {1, -1}) {
      Watch.Values values = (t, y, g) -> g[0] = sign * (y[0] + 1);
      Direction passed = sign > 0 ? Direction.RISING : Direction.FALLING;
      Direction ahead = sign > 0 ? Direction.FALLING : Direction.RISING;
      assertThat(watchTime(passed, values, 1).atStart).containsExactly(NoEvent.PASSED_AT_START);
      assertThat(watchTime(ahead, values, 1).atStart).isEmpty();
      assertThat(watchTime(Direction.EITHER, values, 1).atStart).isEmpty();
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.011, 0.5, 0.7, 1.23456})
  void poleIsNoEventAndIsTold(double at) {
    List<Watch.Values> poles =
        List.of(
            (t, y, g) -> g[0] = 1 / (y[0] - at),
            (t, y, g) -> g[0] = 1 / Math.pow(y[0] - at, 3),
            (t, y, g) -> g[0] = 1 / Math.cbrt(y[0] - at),
            (t, y, g) -> g[0] = 1 / (y[0] - at) - 3,
            (t, y, g) -> g[0] = Math.tan(y[0] - at + 0.5 * Math.PI));
    for (Watch.Values pole : poles) {
      Watch watch = watchTime(Direction.EITHER, pole, 2);
      assertThat(watch.poles).hasSize(1);
      assertThat(watch.poles.get(0)).isCloseTo(at, within(1e-9));
    }
    assertThat(watchTime(Direction.EITHER, poles.get(0), 2).times).isEmpty();
    // The one with - 3 also passes zero, which is an event.
    Watch shifted = watchTime(Direction.EITHER, poles.get(3), 2 + at);
    assertThat(shifted.times).hasSize(1);
    assertThat(shifted.times.get(0)).isCloseTo(at + 1 / 3.0, within(1e-9));
  }

  @Test
  void steepFunctionsAndJumpsPassZeroWithEvents() {
    List<Watch.Values> steep =
        List.of(
            (t, y, g) -> g[0] = Math.signum(y[0] - 0.7),
            (t, y, g) -> g[0] = Math.signum(y[0] - 0.7) * (2 - Math.abs(y[0] - 0.7)),
            (t, y, g) -> g[0] = Math.atan(1e9 * (y[0] - 0.7)),
            (t, y, g) -> g[0] = Math.cbrt(y[0] - 0.7),
            (t, y, g) -> g[0] = 1e12 * (y[0] - 0.7));
    for (Watch.Values values : steep) {
      Watch watch = watchTime(Direction.EITHER, values, 2);
      assertThat(watch.times).hasSize(1);
      assertThat(watch.times.get(0)).isCloseTo(0.7, within(1e-9));
      assertThat(watch.poles).isEmpty();
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.011, 0.5, 0.7, 1.23456, 1.5})
  void touchIsNoEventAndIsTold(double at) {
    List<Watch.Values> touching =
        List.of(
            (t, y, g) -> g[0] = Math.abs(y[0] - at),
            (t, y, g) -> g[0] = (y[0] - at) * (y[0] - at),
            (t, y, g) -> g[0] = -Math.abs(y[0] - at),
            (t, y, g) -> g[0] = 1 - StrictMath.cos(y[0] - at));
    for (Watch.Values touch : touching) {
      for (Direction direction : Direction.values()) {
        Watch watch = watchTime(direction, touch, 2);
        assertThat(watch.times).isEmpty();
        assertThat(watch.touches).hasSize(1);
        // The square is below the resolution of 1e-9 within 3e-5.
        assertThat(watch.touches.get(0)).isCloseTo(at, within(1e-4));
      }
    }
  }

  @Test
  void functionThatStaysAwayFromZeroDoesNotTouchIt() {
    List<Watch.Values> away =
        List.of(
            (t, y, g) -> g[0] = Math.abs(y[0] - 0.7) + 1e-6,
            (t, y, g) -> g[0] = 1.000001 + StrictMath.sin(7 * y[0]),
            (t, y, g) -> g[0] = 1 + y[0]);
    for (Watch.Values values : away) {
      Watch watch = watchTime(Direction.EITHER, values, 5);
      assertThat(watch.times).isEmpty();
      assertThat(watch.touches).isEmpty();
    }
  }

  /** Dips below zero of any shape between two points of the search are two events. */
  @Test
  void dipsBetweenTwoPointsOfTheSearchAreFound() {
    long seed = 42;
    Random random = new Random(seed);
    for (int k = 0; k < 400; k++) {
      double at = 0.05 + 1.9 * random.nextDouble();
      double depth = Math.pow(10, -3 - 8 * random.nextDouble());
      boolean kink = random.nextBoolean();
      double sign = random.nextBoolean() ? 1 : -1;
      double half = kink ? depth : Math.sqrt(depth);
      Watch.Values dip =
          (t, y, g) -> {
            double x = Math.abs(y[0] - at);
            g[0] = sign * ((kink ? x : x * x) - depth);
          };
      Watch watch = watchTime(Direction.EITHER, dip, 2);
      assertThat(watch.times).as("seed %d, dip %d, %s at %s", seed, k, depth, at).hasSize(2);
      // The level of the search, u, over the slope at the zero.
      double width = 1e-12 + (kink ? 0 : 1e-15 / half);
      assertThat(watch.times.get(0)).isCloseTo(at - half, within(width));
      assertThat(watch.times.get(1)).isCloseTo(at + half, within(width));
    }
  }

  /** A body thrown to a height of 0.5 that rises 1e-9 above a level, for 90 µs. */
  @Test
  void levelThatIsOnlyJustCrossedIsSeen() {
    double over = 1e-9;
    FunctionOde flight =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = y[1];
              yDot[1] = -1;
            });
    Watch.Values height = (t, y, g) -> g[0] = y[0] - (0.5 - over);
    Watch level = new Watch(1, Direction.EITHER, Reaction.CONTINUE, height);
    run(new EventIntegration(create(1e-10), level), flight, new double[] {0, 1}, 2);
    assertThat(level.times).hasSize(2);
    // An error of 1e-10 in the height of a parabola that stands 1e-9 above the level.
    double half = Math.sqrt(2 * over);
    assertThat(level.times.get(0)).isCloseTo(1 - half, within(0.1 * half));
    assertThat(level.times.get(1)).isCloseTo(1 + half, within(0.1 * half));
  }
}
