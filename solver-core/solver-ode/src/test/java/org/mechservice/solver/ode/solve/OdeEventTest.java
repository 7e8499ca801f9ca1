package org.mechservice.solver.ode.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.ode.events.EventFunctions.NoEvent;

/** Events of the solution, one by one. */
class OdeEventTest {
  private static final double G = 10;

  /** A ball in free fall, y = (height, velocity). */
  private static final OdeFunction FALL =
      (t, y, yDot) -> {
        yDot[0] = y[1];
        yDot[1] = -G;
      };

  private static final OdeFunction ROTATION =
      (t, y, yDot) -> {
        yDot[0] = y[1];
        yDot[1] = -y[0];
      };

  private static final OdeEvent FLOOR = OdeEvent.when((t, y) -> y[0]).falling().named("floor");

  private static OdeOptions with(OdeEvent... events) {
    OdeOptions options = OdeOptions.standard().rtol(1e-9).atol(1e-11);
    for (OdeEvent event : events) {
      options = options.event(event);
    }
    return options;
  }

  @ParameterizedTest
  @EnumSource
  void ballBouncesWhenAndAsHighAsMechanicsSays(OdeMethod method) {
    OdeEvent bounce = FLOOR.then((t, y) -> y[1] = -0.5 * y[1]);
    OdeSolution solution =
        Ode.solve(FALL, 0, new double[] {5, 0}, 2.2, with(bounce).method(method));
    // Down in 1 s to the speed 10; then up at 5 and down for 1 s; up at 2.5 for 0.25 s.
    assertThat(solution.events()).hasSize(2);
    FoundEvent first = solution.events().get(0);
    assertThat(first.time()).isCloseTo(1, within(1e-7));
    assertThat(first.before()[1]).isCloseTo(-10, within(1e-6));
    assertThat(first.after()[1]).isCloseTo(5, within(1e-6));
    assertThat(first.index()).isZero();
    assertThat(first.name()).isEqualTo("floor");
    assertThat(solution.events().get(1).time()).isCloseTo(2, within(1e-6));
    assertThat(solution.at(1.5)[0]).isCloseTo(1.25, within(1e-6));
    assertThat(solution.endState()[1]).isCloseTo(0.5, within(1e-5));
  }

  @Test
  void atAnEventTheSolutionIsTheStateBehindIt() {
    OdeSolution solution =
        Ode.solve(
            FALL, 0, new double[] {5, 0}, 1.5, with(FLOOR.then((t, y) -> y[1] = -0.5 * y[1])));
    FoundEvent bounce = solution.events().get(0);
    double[] yDot = new double[2];
    double[] y = new double[2];
    solution.at(bounce.time(), y, yDot);
    assertThat(y).isEqualTo(bounce.after());
    assertThat(yDot[0]).isCloseTo(5, within(1e-3));
    assertThat(solution.at(Math.nextDown(bounce.time()))[1]).isCloseTo(-10, within(1e-6));
    assertThat(solution.at(Math.nextUp(bounce.time()))[1]).isCloseTo(5, within(1e-6));
  }

  @ParameterizedTest
  @EnumSource
  void terminalEventEndsTheIntegration(OdeMethod method) {
    OdeSolution solution =
        Ode.solve(FALL, 0, new double[] {5, 0}, 9, with(FLOOR.terminal()).method(method));
    assertThat(solution.endReason()).isEqualTo(EndReason.EVENT);
    assertThat(solution.end()).isCloseTo(1, within(1e-7));
    assertThat(solution.requestedEnd()).isEqualTo(9);
    assertThat(solution.endState()[0]).isCloseTo(0, within(1e-8));
    assertThat(solution.at(solution.end())).isEqualTo(solution.endState());
  }

  @Test
  void terminalEventChangesTheStateBeforeItEnds() {
    OdeEvent stop = FLOOR.terminal().then((t, y) -> y[1] = 0);
    OdeSolution solution = Ode.solve(FALL, 0, new double[] {5, 0}, 9, with(stop));
    assertThat(solution.endState()[1]).isZero();
    assertThat(solution.at(solution.end())[1]).isZero();
    assertThat(solution.events().get(0).before()[1]).isCloseTo(-10, within(1e-6));
  }

  @Test
  void eventIsTerminalAfterSomeTimes() {
    OdeEvent third = OdeEvent.when((t, y) -> y[0]).terminalAfter(3);
    OdeSolution solution = Ode.solve(ROTATION, 0, new double[] {1, 0}, 99, with(third));
    assertThat(solution.end()).isCloseTo(2.5 * Math.PI, within(1e-6));
    assertThat(solution.events()).hasSize(3);
  }

  @Test
  void directionSelectsTheChangesOfSign() {
    OdeEvent zero = OdeEvent.when((t, y) -> y[0]);
    OdeSolution solution =
        Ode.solve(ROTATION, 0, new double[] {1, 0}, 10, with(zero, zero.rising(), zero.falling()));
    assertThat(times(solution, 0)).hasSize(3);
    assertThat(times(solution, 1)).hasSize(1);
    assertThat(times(solution, 1).get(0)).isCloseTo(1.5 * Math.PI, within(1e-7));
    assertThat(times(solution, 2)).hasSize(2);
  }

  private static List<Double> times(OdeSolution solution, int index) {
    return solution.events().stream()
        .filter(event -> event.index() == index)
        .map(FoundEvent::time)
        .toList();
  }

  @Test
  void backwardsDirectionsAreThoseOfTheIntegration() {
    OdeEvent zero = OdeEvent.when((t, y) -> y[0]);
    OdeSolution solution =
        Ode.solve(ROTATION, 0, new double[] {1, 0}, -4, with(zero.falling(), zero.rising()));
    assertThat(times(solution, 0)).hasSize(1);
    assertThat(times(solution, 0).get(0)).isCloseTo(-0.5 * Math.PI, within(1e-7));
    assertThat(times(solution, 1)).isEmpty();
  }

  @Test
  void eventsOfOneTimeSeeEachOthersChanges() {
    OdeEvent doubled = FLOOR.then((t, y) -> y[1] = -2 * y[1]);
    OdeEvent shifted = FLOOR.then((t, y) -> y[1] += 1);
    OdeSolution solution = Ode.solve(FALL, 0, new double[] {5, 0}, 1.5, with(doubled, shifted));
    assertThat(solution.events()).hasSize(2);
    assertThat(solution.events().get(0).after()[1]).isCloseTo(21, within(1e-6));
    assertThat(solution.events().get(1).after()).isEqualTo(solution.events().get(0).after());
  }

  @Test
  void equationsMayChangeAtAnEvent() {
    double[] force = {1};
    OdeEvent turn = OdeEvent.when((t, y) -> t - 1).rising().then((t, y) -> force[0] = -1);
    OdeSolution solution =
        Ode.solve(
            (t, y, yDot) -> yDot[0] = force[0],
            0,
            new double[] {0},
            3,
            with(turn).method(OdeMethod.ODE113));
    assertThat(solution.at(1)[0]).isCloseTo(1, within(1e-9));
    assertThat(solution.endState()[0]).isCloseTo(-1, within(1e-9));
  }

  // A function that is zero at the start

  @Test
  void ballOnTheFloorThatMovesDownHitsItAtOnce() {
    OdeEvent bounce = FLOOR.then((t, y) -> y[1] = -y[1]);
    OdeSolution solution = Ode.solve(FALL, 0, new double[] {0, -5}, 1.5, with(bounce));
    assertThat(solution.events()).hasSize(2);
    assertThat(solution.events().get(0).time()).isZero();
    assertThat(solution.startState()[1]).isEqualTo(5);
    assertThat(solution.at(0)[1]).isEqualTo(5);
    assertThat(solution.events().get(1).time()).isCloseTo(1, within(1e-7));
  }

  @Test
  void ballAtRestOnTheFloorWithoutSupportFallsThroughItAtOnce() {
    OdeSolution solution = Ode.solve(FALL, 0, new double[] {0, 0}, 1, with(FLOOR.terminal()));
    assertThat(solution.end()).isZero();
    assertThat(solution.endReason()).isEqualTo(EndReason.EVENT);
    assertThat(solution.steps()).isEmpty();
    assertThat(solution.endState()).containsExactly(0, 0);
  }

  @Test
  void ballThrownUpFromTheFloorReturnsToIt() {
    OdeEvent either = OdeEvent.when((t, y) -> y[0]).terminal();
    for (OdeEvent event : List.of(FLOOR.terminal(), either)) {
      OdeSolution solution = Ode.solve(FALL, 0, new double[] {0, 5}, 9, with(event));
      assertThat(solution.end()).isCloseTo(1, within(1e-7));
    }
  }

  // What looks like an event and is none, and what does not look like one and is

  @Test
  void functionThatIsFlatZeroBeforeItRisesHasItsEvent() {
    OdeEvent touch = OdeEvent.when((t, y) -> Math.max(0, 1 - y[0])).rising().terminal();
    OdeSolution solution = Ode.solve(FALL, 0, new double[] {5, 0}, 4, with(touch));
    assertThat(solution.endReason()).isEqualTo(EndReason.EVENT);
    assertThat(solution.end()).isCloseTo(Math.sqrt(2 * 4 / 10.0), within(1e-7));
    assertThat(solution.eventRemarks()).isEmpty();
  }

  @Test
  void polesTouchesAndLimitsPassedAreRemarked() {
    List<OdeEvent> events =
        List.of(
            OdeEvent.when((t, y) -> 1 / (t - 0.7)).named("pole"),
            OdeEvent.when((t, y) -> Math.abs(t - 0.7) * Math.abs(t - 1.3)).named("touch"),
            OdeEvent.when((t, y) -> t + 1).rising().named("limit"),
            OdeEvent.when((t, y) -> Math.cos(t)).falling(),
            OdeEvent.when((t, y) -> -Math.cos(2 * t)).falling().named("again"));
    OdeSolution solution =
        Ode.solve(FALL, 0, new double[] {5, 0}, 3, with(events.toArray(OdeEvent[]::new)));
    assertThat(solution.events().stream().map(FoundEvent::index)).containsExactly(3, 4);
    assertThat(solution.eventRemarks().stream().map(EventRemark::name))
        .containsExactly("pole", "touch", "limit");
    assertThat(solution.eventRemarks().stream().map(EventRemark::reason))
        .containsExactly(NoEvent.POLE, NoEvent.TOUCH, NoEvent.PASSED_AT_START);
    assertThat(solution.eventRemarks().get(0).time()).isCloseTo(0.7, within(1e-9));
    EventRemark touch = solution.eventRemarks().get(1);
    assertThat(touch.time()).isCloseTo(0.7, within(1e-5));
    assertThat(touch.count()).isEqualTo(2);
    assertThat(touch.toString()).startsWith("the function of event 1 (touch) comes to zero at t");
    assertThat(solution.eventRemarks().get(2).value()).isEqualTo(1);
  }

  // Outputs at events

  @Test
  void outputAtTheTimeOfAnEventIsTheStateBehindIt() {
    List<double[]> told = new ArrayList<>();
    OdeEvent jump = OdeEvent.when((t, y) -> t - 1).rising().then((t, y) -> y[0] = 7);
    OdeOptions options = with(jump).method(OdeMethod.ODE113);
    double at =
        Ode.solve((t, y, yDot) -> yDot[0] = 0, 0, new double[] {0}, 2, options)
            .events()
            .get(0)
            .time();
    Ode.solve(
        (t, y, yDot) -> yDot[0] = 0,
        0,
        new double[] {0},
        2,
        options.output(new double[] {0.5, at, 2}, (t, y) -> told.add(y.clone())));
    assertThat(told).containsExactly(new double[] {0}, new double[] {7}, new double[] {7});
  }

  // Failures and wrong use

  @Test
  void bouncesThatAccumulateEndWithAdvice() {
    OdeEvent bounce = FLOOR.then((t, y) -> y[1] = -0.5 * y[1]);
    assertThatThrownBy(() -> Ode.solve(FALL, 0, new double[] {5, 0}, 5, with(bounce)))
        .isInstanceOf(IntegrationException.class)
        .hasMessageContaining("events follow each other ever closer")
        .hasMessageContaining("terminal");
  }

  @Test
  void eventFunctionThatIsNotFiniteIsNamed() {
    OdeEvent root = OdeEvent.when((t, y) -> Math.sqrt(y[0])).named("depth");
    assertThatThrownBy(() -> Ode.solve(FALL, 0, new double[] {5, 0}, 5, with(root)))
        .isInstanceOf(IntegrationException.class)
        .hasMessageContaining("the function of event 0 (depth) is not finite");
  }

  @Test
  void badEventsAreRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> FLOOR.terminalAfter(0))
        .withMessageContaining("after 0 times");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> FLOOR.hysteresis(-1))
        .withMessageContaining("hysteresis of an event is -1.0");
    OdeEvent broken = FLOOR.then((t, y) -> y[1] = Double.NaN);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Ode.solve(FALL, 0, new double[] {5, 0}, 5, with(broken)))
        .withMessageContaining("action of event 0 (floor)")
        .withMessageContaining("y[1] to NaN");
  }

  @Test
  @SuppressWarnings("NullAway") // what callers without checks may hand in
  void nullIsRefusedWithWhatToWriteInstead() {
    assertThatNullPointerException()
        .isThrownBy(() -> OdeEvent.when(null))
        .withMessageContaining("give g(t, y)");
    assertThatNullPointerException()
        .isThrownBy(() -> FLOOR.then(null))
        .withMessageContaining("leave then(...) out");
    assertThatNullPointerException()
        .isThrownBy(() -> FLOOR.named(null))
        .withMessageContaining("leave named(...) out");
    assertThatNullPointerException()
        .isThrownBy(() -> OdeOptions.standard().event(null))
        .withMessageContaining("build one by OdeEvent.when(...)");
  }
}
