package org.mechservice.solver.ode.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.SavedSystem;

/** An integration is cancelled, saved and taken up again with the same bits. */
class OdeCheckpointTest {
  /** A ball that bounces on a floor which shakes. */
  private static final OdeFunction BALL =
      (t, y, yDot) -> {
        yDot[0] = y[1];
        yDot[1] = -10 - 0.1 * y[1] * Math.abs(y[1]);
      };

  private static final double[] START = {5, 0};
  private static final double END = 6;

  private static OdeOptions options(OdeMethod method) {
    return OdeOptions.standard()
        .method(method)
        .event(
            OdeEvent.when((t, y) -> y[0] - 0.05 * StrictMath.sin(20 * t))
                .falling()
                .then((t, y) -> y[1] = Math.abs(y[1])));
  }

  @ParameterizedTest
  @EnumSource
  void checkpointGoesOnWithTheSameBits(OdeMethod method) {
    List<OdeCheckpoint> checkpoints = new ArrayList<>();
    List<Double> told = new ArrayList<>();
    OdeOptions plain = options(method);
    OdeSolution whole =
        Ode.solve(
            BALL,
            0,
            START,
            END,
            plain.outputEvery(0.25, (t, y) -> told.add(y[0])).checkpointEvery(7, checkpoints::add));
    assertThat(checkpoints).hasSizeGreaterThan(5);
    assertThat(whole.events()).hasSizeGreaterThan(2);
    for (OdeCheckpoint checkpoint : checkpoints) {
      List<Double> rest = new ArrayList<>();
      OdeSolution later =
          Ode.resume(
              Ode.system(2, BALL),
              OdeCheckpoint.of(checkpoint.bytes()),
              plain.outputEvery(0.25, (t, y) -> rest.add(y[0])));
      assertThat(later.endState()).isEqualTo(whole.endState());
      assertThat(later.statistics()).isEqualTo(whole.statistics());
      assertThat(later.startState()).isEqualTo(whole.at(later.start()));
      double place = later.start() + 0.7 * (END - later.start());
      assertThat(later.at(place)).isEqualTo(whole.at(place));
      assertThat(rest).isEqualTo(told.subList(told.size() - rest.size(), told.size()));
      assertThat(later.events().stream().map(FoundEvent::time))
          .isEqualTo(
              whole.events().stream()
                  .map(FoundEvent::time)
                  .filter(t -> t > later.start())
                  .toList());
    }
  }

  @ParameterizedTest
  @EnumSource
  void cancelledWithinAStepItGoesOnWithTheSameBits(OdeMethod method) {
    OdeSolution whole = Ode.solve(BALL, 0, START, END, options(method));
    long all = whole.statistics().evaluations();
    for (long after = 1; after < 0.9 * all; after += all / 23) {
      AtomicLong asked = new AtomicLong();
      long limit = after;
      OdeSolution first =
          Ode.solve(
              BALL,
              0,
              START,
              END,
              options(method).cancelWhen(() -> asked.incrementAndGet() > limit));
      assertThat(first.endReason()).isEqualTo(EndReason.CANCELLED);
      OdeSolution second = Ode.resume(Ode.system(2, BALL), first.checkpoint(), options(method));
      assertThat(second.start()).isEqualTo(first.end());
      assertThat(second.startState()).isEqualTo(first.endState());
      assertThat(second.endState()).isEqualTo(whole.endState());
      // Evaluations of the step that was cancelled are repeated.
      assertThat(second.statistics().steps()).isEqualTo(whole.statistics().steps());
      assertThat(first.events().size() + second.events().size()).isEqualTo(whole.events().size());
      double middle = 0.5 * (second.start() + END);
      assertThat(second.at(middle)).isEqualTo(whole.at(middle));
    }
  }

  @ParameterizedTest
  @EnumSource
  void runInManyPartsTellsTheSameOutputs(OdeMethod method) {
    double[] back = {StrictMath.cos(3), -StrictMath.sin(3)};
    OdeProblem rotation =
        Ode.system(
            2,
            (t, y, yDot) -> {
              yDot[0] = y[1];
              yDot[1] = -y[0];
            });
    List<Double> whole = new ArrayList<>();
    List<Double> parts = new ArrayList<>();
    OdeOptions plain = OdeOptions.standard().method(method);
    double[] end =
        Ode.solve(rotation, 3, back, 0, plain.outputEvery(0.13, (t, y) -> whole.add(y[0])))
            .endState();
    OdeOptions byStep = plain.outputEvery(0.13, (t, y) -> parts.add(y[0])).onStep(SolvedStep::stop);
    OdeSolution part = Ode.solve(rotation, 3, back, 0, byStep);
    while (part.endReason() == EndReason.STOPPED) {
      part = Ode.resume(rotation, part.checkpoint(), byStep);
    }
    assertThat(parts).isEqualTo(whole);
    assertThat(part.endState()).isEqualTo(end);
    OdeSolution nothingLeft = Ode.resume(rotation, part.checkpoint(), byStep);
    assertThat(nothingLeft.start()).isZero();
    assertThat(nothingLeft.end()).isZero();
    assertThat(nothingLeft.endState()).isEqualTo(end);
    assertThat(parts).hasSameSizeAs(whole);
  }

  @Test
  void terminalEventOfTheStartIsTheEndAlsoWhenTakenUp() {
    OdeOptions options =
        OdeOptions.standard().event(OdeEvent.when((t, y) -> y[0]).falling().terminal());
    OdeProblem ball = Ode.system(2, BALL);
    OdeSolution ended = Ode.solve(ball, 0, new double[] {0, -1}, 1, options);
    OdeSolution later = Ode.resume(ball, ended.checkpoint(), options);
    assertThat(later.endReason()).isEqualTo(EndReason.EVENT);
    assertThat(later.end()).isZero();
  }

  @Test
  void residualProblemGoesOnWithTheSameBits() {
    DaeProblem square =
        Dae.system(
                2,
                (t, y, yDot, r) -> {
                  r[0] = yDot[0] + y[0];
                  r[1] = y[1] - y[0] * y[0];
                })
            .withAlgebraic(1);
    List<OdeCheckpoint> checkpoints = new ArrayList<>();
    OdeOptions standard = OdeOptions.standard();
    OdeSolution whole =
        Dae.solve(
            square,
            0,
            new double[] {1, 0},
            new double[2],
            5,
            standard.checkpointEvery(10, checkpoints::add));
    assertThat(checkpoints).isNotEmpty();
    for (OdeCheckpoint checkpoint : checkpoints) {
      OdeSolution later = Dae.resume(square, checkpoint, standard);
      assertThat(later.endState()).isEqualTo(whole.endState());
      assertThat(later.statistics()).isEqualTo(whole.statistics());
    }
  }

  /** A thermostat: its heater is on or off. */
  private static final class Heater implements SavedSystem {
    private boolean on = true;

    @Override
    public void transfer(SavedState state) {
      on = state.flag(on);
    }

    OdeProblem problem() {
      return Ode.system(1, (t, y, yDot) -> yDot[0] = 10 - y[0] + (on ? 15 : 0))
          .with(SavedSystem.class, this);
    }

    OdeOptions options() {
      return OdeOptions.standard()
          .event(OdeEvent.when((t, y) -> y[0] - 21).rising().then((t, y) -> on = false))
          .event(OdeEvent.when((t, y) -> y[0] - 19).falling().then((t, y) -> on = true));
    }
  }

  @Test
  void stateOfTheProblemItselfIsSavedWithTheIntegration() {
    Heater heater = new Heater();
    List<OdeCheckpoint> checkpoints = new ArrayList<>();
    OdeSolution whole =
        Ode.solve(
            heater.problem(),
            0,
            new double[] {15},
            5,
            heater.options().checkpointEvery(20, checkpoints::add));
    assertThat(checkpoints).hasSizeGreaterThan(5);
    for (OdeCheckpoint checkpoint : checkpoints) {
      Heater another = new Heater();
      OdeSolution later = Ode.resume(another.problem(), checkpoint, another.options());
      assertThat(later.endState()).isEqualTo(whole.endState());
      assertThat(another.on).isEqualTo(heater.on);
    }
  }

  @Test
  void massProblemGoesOnWithTheSameBits() {
    MassProblem problem =
        Ode.system(2, BALL).withMass(MassMatrix.full(new double[][] {{2, 1}, {1, 3}}));
    List<OdeCheckpoint> checkpoints = new ArrayList<>();
    OdeOptions standard = OdeOptions.standard();
    OdeSolution whole =
        Ode.solve(problem, 0, START, 1, standard.checkpointEvery(10, checkpoints::add));
    assertThat(checkpoints).isNotEmpty();
    for (OdeCheckpoint checkpoint : checkpoints) {
      assertThat(Ode.resume(problem, checkpoint, standard).endState()).isEqualTo(whole.endState());
    }
  }

  @Test
  @Timeout(60)
  void anotherThreadCancels() throws InterruptedException {
    AtomicBoolean stop = new AtomicBoolean();
    CountDownLatch running = new CountDownLatch(1);
    List<OdeSolution> solutions = new ArrayList<>();
    OdeOptions endless =
        OdeOptions.standard()
            .method(OdeMethod.ODE113)
            .maxSteps(Long.MAX_VALUE)
            .maxStep(1e-3)
            .keepSteps(false)
            .onStep(step -> running.countDown())
            .cancelWhen(stop::get);
    Thread thread =
        new Thread(
            () ->
                solutions.add(
                    Ode.solve((t, y, yDot) -> yDot[0] = -y[0], 0, new double[] {1}, 1e9, endless)));
    thread.start();
    running.await();
    stop.set(true);
    thread.join();
    assertThat(solutions.get(0).endReason()).isEqualTo(EndReason.CANCELLED);
    assertThat(solutions.get(0).end()).isPositive();
  }

  @Test
  void checkpointOfOtherTolerancesProblemOrBytesIsRefused() {
    OdeOptions options = options(OdeMethod.ODE113);
    OdeProblem ball = Ode.system(2, BALL);
    OdeCheckpoint checkpoint =
        Ode.solve(ball, 0, START, END, options.onStep(SolvedStep::stop)).checkpoint();
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Ode.resume(ball, checkpoint, options.rtol(1e-3)))
        .withMessageContaining("relative tolerance is 0.001")
        .withMessageContaining("1.0E-6");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Ode.resume(ball, checkpoint, options.method(OdeMethod.DE)))
        .withMessageContaining("method is De");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Ode.resume(Ode.system(3, BALL), checkpoint, options))
        .withMessageContaining("3 unknowns")
        .withMessageContaining("2");
    byte[] damaged = checkpoint.bytes();
    damaged[40] ^= 1;
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Ode.resume(ball, OdeCheckpoint.of(damaged), options))
        .withMessageContaining("damaged");
  }

  @Test
  void failedIntegrationHasNoCheckpoint() {
    OdeSolution failed =
        Ode.solve(BALL, 0, START, END, options(OdeMethod.ODE113).maxSteps(3).returnFailures());
    assertThatIllegalStateException()
        .isThrownBy(failed::checkpoint)
        .withMessageContaining("failed or was cancelled at t = " + failed.end());
  }
}
