package org.mechservice.solver.ode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.events.EventFunctions;
import org.mechservice.solver.ode.events.EventIntegration;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.Kepler;
import org.mechservice.solver.ode.suite.LoopPendulum;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.suite.SuiteProblem;
import org.mechservice.solver.ode.suite.VanDerPol;

/** An integration saved and taken up again goes on with the same bits. */
public abstract class CheckpointContract {
  protected abstract Integrator create(IntegratorSettings settings);

  private Integrator create(double tolerance) {
    return create(new IntegratorSettings(tolerance, tolerance));
  }

  /** Everything a run shows: step ends, orders, states at the ends and in the middle. */
  private static List<Double> trace(Integrator integrator, StepResult result, int dimension) {
    List<Double> trace = new ArrayList<>();
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
      trace.add(integrator.time());
      trace.add((double) integrator.order());
      double middle =
          integrator.previousTime() + 0.5 * (integrator.time() - integrator.previousTime());
      for (double t : new double[] {middle, integrator.time()}) {
        for (double y : Run.state(integrator, t, dimension)) {
          trace.add(y);
        }
      }
    }
    assertThat(result).isEqualTo(StepResult.REACHED_END);
    return trace;
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-4, 1e-7, 1e-10, 1e-12})
  void integrationTakenUpGoesOnWithTheSameBits(double tolerance) {
    // After every fifteenth step, in a new integrator.
    SuiteProblem problem = new Kepler();
    IntegratorSettings settings = Run.settings(problem, tolerance);
    Integrator whole = create(settings);
    double[] y0 = problem.reference().initialState();
    List<Double> expected = trace(whole, whole.start(problem, 0, y0, 20), 4);
    Integrator part = create(settings);
    StepResult result = part.start(problem, 0, y0, 20);
    for (int i = 1; result == StepResult.ADVANCED; i++) {
      if (i % 15 == 0) {
        byte[] saved = part.save();
        part = create(settings);
        assertThat(part.resume(new Kepler(), saved)).isEqualTo(StepResult.ADVANCED);
        assertThat(part.save()).isEqualTo(saved);
      }
      if (i == 60) {
        List<Double> rest = trace(part, StepResult.ADVANCED, 4);
        assertThat(rest)
            .isEqualTo(expected.subList(expected.size() - rest.size(), expected.size()));
        assertThat(part.statistics()).isEqualTo(whole.statistics());
        return;
      }
      result = part.step();
    }
    throw new AssertionError("the run is too short to be cut");
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-7, 1e-12})
  void integrationSavedBeforeItsFirstStepGoesOnWithTheSameBits(double tolerance) {
    SuiteProblem problem = new VanDerPol();
    IntegratorSettings settings = Run.settings(problem, tolerance);
    double[] y0 = problem.reference().initialState();
    Integrator whole = create(settings);
    List<Double> expected = trace(whole, whole.start(problem, 0, y0, 20), 2);
    Integrator started = create(settings);
    assertThat(started.start(problem, 0, y0, 20)).isEqualTo(StepResult.ADVANCED);
    byte[] saved = started.save();
    Integrator resumed = create(settings);
    assertThat(resumed.resume(new VanDerPol(), saved)).isEqualTo(StepResult.ADVANCED);
    assertThat(resumed.save()).isEqualTo(saved);
    assertThat(resumed.time()).isZero();
    assertThat(Run.state(resumed, 0, 2)).isEqualTo(y0);
    assertThat(trace(resumed, StepResult.ADVANCED, 2)).isEqualTo(expected);
    assertThat(resumed.statistics()).isEqualTo(whole.statistics());
    // The one that was saved was not changed by it.
    assertThat(trace(started, StepResult.ADVANCED, 2)).isEqualTo(expected);
  }

  @Test
  void integrationSavedBeforeItsFirstStepKnowsJumpsManifoldAndEvents() {
    Pushed pushed = new Pushed();
    Integrator whole = create(1e-7);
    List<Double> expected = trace(whole, whole.start(pushed, 0, new double[2], 5), 2);
    Integrator started = create(1e-7);
    started.start(pushed, 0, new double[2], 5);
    Integrator resumed = create(1e-7);
    assertThat(trace(resumed, resumed.resume(new Pushed(), started.save()), 2)).isEqualTo(expected);

    whole = create(1e-8);
    expected = trace(whole, whole.start(new SavedPendulum(), 0, LoopPendulum.start(), 5), 4);
    started = create(1e-8);
    started.start(new SavedPendulum(), 0, LoopPendulum.start(), 5);
    resumed = create(1e-8);
    assertThat(trace(resumed, resumed.resume(new SavedPendulum(), started.save()), 4))
        .isEqualTo(expected);

    double[] thrown = {0, 10};
    Bounces all = new Bounces();
    whole = new EventIntegration(create(1e-8), all);
    expected = trace(whole, whole.start(FALL, 0, thrown, 10), 2);
    started = new EventIntegration(create(1e-8), new Bounces());
    started.start(FALL, 0, thrown, 10);
    Bounces counted = new Bounces();
    resumed = new EventIntegration(create(1e-8), counted);
    assertThat(trace(resumed, resumed.resume(FALL, started.save()), 2)).isEqualTo(expected);
    assertThat(counted.bounces).isEqualTo(all.bounces).isGreaterThan(5);
  }

  @Test
  void savingChangesNothing() {
    SuiteProblem problem = new VanDerPol();
    Integrator saving = create(1e-6);
    StepResult result = saving.start(problem, 0, problem.reference().initialState(), 20);
    while (result == StepResult.ADVANCED) {
      saving.save();
      result = saving.step();
    }
    assertThat(Run.state(saving, 20, 2)).isEqualTo(Run.of(create(1e-6), problem).atEnd());
  }

  @Test
  void lastStepCanBeInterpolatedAfterItWasTakenUp() {
    Integrator saving = create(1e-6);
    saving.start(new Kepler(), 0, new Kepler().reference().initialState(), 20);
    for (int i = 0; i < 40; i++) {
      saving.step();
    }
    Integrator resumed = create(1e-6);
    resumed.resume(new Kepler(), saving.save());
    double t = saving.previousTime() + 0.3 * saving.stepSize();
    assertThat(Run.state(resumed, t, 4)).isEqualTo(Run.state(saving, t, 4));
    assertThat(resumed.time()).isEqualTo(saving.time());
    assertThat(resumed.statistics()).isEqualTo(saving.statistics());
  }

  @Test
  void jumpsPassedStayPassed() {
    Pushed pushed = new Pushed();
    Integrator whole = create(1e-7);
    List<Double> expected = trace(whole, whole.start(pushed, 0, new double[2], 5), 2);
    for (double from : new double[] {0.5, 1, 1.5, 2, 3}) {
      Integrator part = create(1e-7);
      part.start(pushed, 0, new double[2], 5);
      while (part.time() < from) {
        part.step();
      }
      Integrator resumed = create(1e-7);
      List<Double> rest = trace(resumed, resumed.resume(new Pushed(), part.save()), 2);
      assertThat(rest).isEqualTo(expected.subList(expected.size() - rest.size(), expected.size()));
    }
  }

  /** An oscillator pushed from t = 1 to t = 2. */
  private static final class Pushed implements OdeSystem, PiecewiseSystem {
    @Override
    public int dimension() {
      return 2;
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {
      yDot[0] = y[1];
      yDot[1] = (t >= 1 && t < 2 ? 50 : 0) - 0.4 * y[1] - 100 * y[0];
    }

    @Override
    public List<Double> breakpoints() {
      return List.of(1.0, 2.0);
    }
  }

  /** A rod that remembers which coordinate is independent. */
  private static final class SavedPendulum extends LoopPendulum implements SavedSystem {
    @Override
    public void transfer(SavedState state) {
      transferChoice(state);
    }
  }

  @Test
  void stateOfTheProblemItselfIsTakenUpToo() {
    Integrator whole = create(1e-8);
    List<Double> expected =
        trace(whole, whole.start(new SavedPendulum(), 0, LoopPendulum.start(), 5), 4);
    Integrator part = create(1e-8);
    SavedPendulum pendulum = new SavedPendulum();
    part.start(pendulum, 0, LoopPendulum.start(), 5);
    while (pendulum.changes() < 3) {
      part.step();
    }
    Integrator resumed = create(1e-8);
    List<Double> rest = trace(resumed, resumed.resume(new SavedPendulum(), part.save()), 4);
    assertThat(rest).isEqualTo(expected.subList(expected.size() - rest.size(), expected.size()));
  }

  private static final FunctionOde FALL =
      new FunctionOde(
          2,
          (t, y, yDot) -> {
            yDot[0] = y[1];
            yDot[1] = -9.81;
          });

  /** A ball that keeps 80 % of its speed; the bounces are counted. */
  private static final class Bounces implements EventFunctions, SavedSystem {
    private int bounces;

    @Override
    public int count() {
      return 1;
    }

    @Override
    public void evaluate(double t, double[] y, double[] g) {
      g[0] = y[0];
    }

    @Override
    public Direction direction(int function) {
      return Direction.FALLING;
    }

    @Override
    public Reaction occurred(double t, double[] y, boolean[] occurred) {
      bounces++;
      y[1] = -0.8 * y[1];
      return Reaction.RESTART;
    }

    @Override
    public void transfer(SavedState state) {
      bounces = state.integer(bounces);
    }
  }

  @Test
  void eventsAreFoundAsIfNothingHadBeenSaved() {
    double[] y0 = {10, 0};
    Bounces all = new Bounces();
    EventIntegration whole = new EventIntegration(create(1e-8), all);
    List<Double> expected = trace(whole, whole.start(FALL, 0, y0, 10), 2);
    Bounces counted = new Bounces();
    EventIntegration part = new EventIntegration(create(1e-8), counted);
    StepResult result = part.start(FALL, 0, y0, 10);
    while (result == StepResult.ADVANCED) {
      result = part.step();
      byte[] saved = part.save();
      counted = new Bounces();
      part = new EventIntegration(create(1e-8), counted);
      assertThat(part.resume(FALL, saved)).isEqualTo(result);
    }
    assertThat(counted.bounces).isEqualTo(all.bounces).isGreaterThan(5);
    double[] atEnd = Run.state(part, 10, 2);
    assertThat(atEnd[1]).isEqualTo(expected.get(expected.size() - 1));
    assertThat(part.statistics()).isEqualTo(whole.statistics());
  }

  // Refusals

  private byte[] saved() {
    Integrator integrator = create(1e-6);
    integrator.start(new Kepler(), 0, new Kepler().reference().initialState(), 20);
    for (int i = 0; i < 10; i++) {
      integrator.step();
    }
    return integrator.save();
  }

  @Test
  void otherSettingsAreRefusedByName() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> create(1e-7).resume(new Kepler(), saved()))
        .withMessage("the relative tolerance is 1.0E-7, but that of the saved state is 1.0E-6");
  }

  @ParameterizedTest
  @EnumSource(value = Mode.class, names = "STANDARD", mode = EnumSource.Mode.EXCLUDE)
  void otherModeIsRefusedByName(Mode mode) {
    Integrator other = create(new IntegratorSettings(1e-6, 1e-6).withMode(mode));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> other.resume(new Kepler(), saved()))
        .withMessage("the mode is " + mode + ", but that of the saved state is STANDARD");
  }

  @Test
  void otherNumberOfUnknownsIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> create(1e-6).resume(new VanDerPol(), saved()))
        .withMessage("the number of unknowns is 2, but that of the saved state is 4");
  }

  @Test
  void everyDamagedByteIsNoticed() {
    byte[] whole = saved();
    long seed = 20261121;
    Random random = new Random(seed);
    for (int i = 0; i < 200; i++) {
      byte[] damaged = whole.clone();
      int at = random.nextInt(damaged.length);
      damaged[at] ^= (byte) (1 << random.nextInt(8));
      assertThatIllegalArgumentException()
          .as("seed %d, byte %d", seed, at)
          .isThrownBy(() -> create(1e-6).resume(new Kepler(), damaged))
          .withMessageContaining("damaged");
    }
    for (int length : new int[] {0, 7, 8, 20, whole.length - 1}) {
      byte[] cut = Arrays.copyOf(whole, length);
      assertThatIllegalArgumentException()
          .isThrownBy(() -> create(1e-6).resume(new Kepler(), cut))
          .withMessageContaining("damaged");
    }
  }

  @Test
  void nothingToGoOnFromIsRefused() {
    Integrator fresh = create(1e-6);
    assertThatIllegalStateException().isThrownBy(fresh::save);
    int[] evaluations = {0};
    Integrator stopping =
        create(
            new IntegratorSettings(
                1e-6,
                List.of(1e-6),
                Double.POSITIVE_INFINITY,
                0,
                0,
                Long.MAX_VALUE,
                () -> ++evaluations[0] > 30));
    Kepler kepler = new Kepler();
    StepResult result = stopping.start(kepler, 0, kepler.reference().initialState(), 20);
    while (result == StepResult.ADVANCED) {
      result = stopping.step();
    }
    assertThat(result).isEqualTo(StepResult.STOPPED);
    assertThatIllegalStateException().isThrownBy(stopping::save);
  }
}
