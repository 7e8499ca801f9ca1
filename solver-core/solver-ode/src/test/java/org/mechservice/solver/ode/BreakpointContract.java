package org.mechservice.solver.ode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.LongToDoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.suite.Run;

/** Jumps of the equations at declared places, whatever the integrator. */
public abstract class BreakpointContract {
  /** State of the pushed oscillator at t = 2.5 and t = 5, in closed form (suite: step_force). */
  private static final double[] AT_CHECKPOINT = {0.3950552192759746, 6.758143140404665};

  /** By which a piece of some ten steps may err, each by a tolerance. */
  private static final double TOLERANCES_A_PIECE = 10;

  private static final double[] AT_END = {0.18039197239119287, 4.400526629628046};

  protected abstract Integrator create(IntegratorSettings settings);

  private static IntegratorSettings tolerances(double both) {
    return new IntegratorSettings(both, both);
  }

  private Integrator create(double tolerance) {
    return create(tolerances(tolerance));
  }

  /** An oscillator on which a force acts from t = 1 to t = 2; remembers where it was evaluated. */
  private static class Pushed implements OdeSystem, PiecewiseSystem {
    final List<Double> evaluated = new ArrayList<>();
    private final List<Double> breakpoints;

    Pushed(Double... breakpoints) {
      this.breakpoints = List.of(breakpoints);
    }

    @Override
    public int dimension() {
      return 2;
    }

    boolean pushed(double t) {
      return t >= 1 && t < 2;
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {
      evaluated.add(t);
      yDot[0] = y[1];
      yDot[1] = (pushed(t) ? 50 : 0) - 0.4 * y[1] - 100 * y[0];
    }

    @Override
    public List<Double> breakpoints() {
      return breakpoints;
    }
  }

  /** The same with places that are not listed, from the start on every quarter. */
  private static final class Sampled extends Pushed {
    private final double direction;

    Sampled(double direction, Double... breakpoints) {
      super(breakpoints);
      this.direction = direction;
    }

    @Override
    public LongToDoubleFunction sequence() {
      return k -> k <= 20 ? (direction < 0 ? 5 - 0.25 * k : 0.25 * k) : Double.NaN;
    }
  }

  /** Places of a list and of a sequence are one ascending list, of which some are the same. */
  @ParameterizedTest
  @ValueSource(doubles = {1, -1})
  void placesOfASequenceAreThoseOfAList(double direction) {
    double from = direction > 0 ? 0 : 5;
    double to = 5 - from;
    Double[] all = IntStream.rangeClosed(0, 22).mapToObj(k -> 0.25 * k).toArray(Double[]::new);
    all[21] = 0.6;
    all[22] = 1.25 + 1e-15;
    Run listed = Run.of(create(1e-7), new Pushed(all), from, new double[] {0.1, 1}, to);
    Pushed sampled = new Sampled(direction, 2.0, 1.0, 0.6, 1.25 + 1e-15);
    Run ofBoth = Run.of(create(1e-7), sampled, from, new double[] {0.1, 1}, to);
    assertThat(ofBoth.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(ofBoth.atEnd()).isEqualTo(listed.atEnd());
  }

  /** Places before the start are left alone, and those within rounding are one. */
  @Test
  void placesBehindAndPlacesThatAreOneCostNoSteps() {
    double[] y = {0.1, 1};
    Run listed = Run.of(create(1e-7), new Pushed(1.25, 1.5, 1.75, 2.0), 1.1, y, 2.1);
    class Early extends Pushed {
      Early(Double... breakpoints) {
        super(breakpoints);
      }

      @Override
      public LongToDoubleFunction sequence() {
        return k -> 0.25 * k;
      }
    }
    Run early = Run.of(create(1e-7), new Early(0.5, 1.0), 1.1, y, 2.1);
    assertThat(early.atEnd()).isEqualTo(listed.atEnd());
    Integrator one = create(1e-7);
    Run.of(one, new Pushed(1.5), 1.1, y, 2.1);
    Integrator same = create(1e-7);
    Run.of(same, new Pushed(1.5, Math.nextUp(1.5), 1.5 + 1e-14), 1.1, y, 2.1);
    assertThat(same.statistics().steps()).isEqualTo(one.statistics().steps());
  }

  /** A sequence of a thousand million places takes no memory, and is taken up in its middle. */
  @Test
  void placesWithoutEndAreTakenUp() {
    class Endless extends Pushed {
      @Override
      public LongToDoubleFunction sequence() {
        return k -> 0.25 * k;
      }
    }
    Integrator whole = create(1e-7);
    StepResult result = whole.start(new Endless(), 0, new double[] {0.1, 1}, 1e9);
    while (result == StepResult.ADVANCED && whole.time() < 5) {
      result = whole.step();
    }
    Integrator first = create(1e-7);
    result = first.start(new Endless(), 0, new double[] {0.1, 1}, 1e9);
    while (result == StepResult.ADVANCED && first.time() < 2.1) {
      result = first.step();
    }
    Integrator second = create(1e-7);
    result = second.resume(new Endless(), first.save());
    while (result == StepResult.ADVANCED && second.time() < 5) {
      result = second.step();
    }
    assertThat(second.time()).isEqualTo(whole.time()).isEqualTo(5);
    assertThat(Run.state(second, 5, 2)).isEqualTo(Run.state(whole, 5, 2));
  }

  private static double digits(double[] y, double[] reference) {
    double worst = 0;
    for (int i = 0; i < y.length; i++) {
      worst = Math.max(worst, Math.abs(y[i] - reference[i]) / (1 + Math.abs(reference[i])));
    }
    return -StrictMath.log10(worst);
  }

  /** A mass on a spring under a force that changes its sign a hundred times: arcs about ±0.1. */
  @ParameterizedTest
  @ValueSource(ints = {3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
  void squareWaveIsIntegratedAtEveryTolerance(int k) {
    double[] places = IntStream.rangeClosed(1, 99).mapToDouble(i -> i / 50.0).toArray();
    class Wave implements OdeSystem, PiecewiseSystem {
      @Override
      public int dimension() {
        return 2;
      }

      @Override
      public void derivative(double t, double[] y, double[] yDot) {
        yDot[0] = y[1];
        int piece = -Arrays.binarySearch(places, t) - 1;
        yDot[1] = (piece % 2 == 0 ? 10 : -10) - 100 * y[0];
      }

      @Override
      public List<Double> breakpoints() {
        return Arrays.stream(places).boxed().toList();
      }
    }
    double[] exact = new double[2];
    double cosine = StrictMath.cos(0.2);
    double sine = StrictMath.sin(0.2);
    for (int i = 0; i < 100; i++) {
      double place = i % 2 == 0 ? 0.1 : -0.1;
      double off = exact[0] - place;
      double speed = exact[1];
      exact[0] = place + off * cosine + 0.1 * speed * sine;
      exact[1] = speed * cosine - 10 * off * sine;
    }
    assertThat(exact[0]).isCloseTo(0.009160006236372595, within(1e-14));
    double tolerance = StrictMath.pow(10, -k);
    IntegratorSettings settings = new IntegratorSettings(tolerance, 0.01 * tolerance);
    Run run = Run.of(create(settings), new Wave(), 0, new double[2], 2);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    // A hundred pieces, each of which may err by some tolerances of a state of size 0.1.
    assertThat(run.atEnd()[0])
        .isCloseTo(exact[0], within(TOLERANCES_A_PIECE * 100 * 0.1 * tolerance));
  }

  @ParameterizedTest
  @CsvSource({
    "3, STANDARD",
    "4, STANDARD",
    "5, STANDARD",
    "6, STANDARD",
    "7, STANDARD",
    "8, STANDARD",
    "9, STANDARD",
    "3, STRICT",
    "6, STRICT",
    "9, STRICT"
  })
  void jumpsDeclaredCostNoDigits(int k, Mode mode) {
    Integrator integrator = create(tolerances(StrictMath.pow(10, -k)).withMode(mode));
    StepResult result = integrator.start(new Pushed(1.0, 2.0), 0, new double[2], 5);
    while (result == StepResult.ADVANCED && integrator.time() < 2.5) {
      result = integrator.step();
    }
    double[] atCheckpoint = Run.state(integrator, 2.5, 2);
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    assertThat(digits(atCheckpoint, AT_CHECKPOINT)).isGreaterThanOrEqualTo(k - 1);
    assertThat(digits(Run.state(integrator, 5, 2), AT_END)).isGreaterThanOrEqualTo(k - 1);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-6, 1e-9})
  void stepsEndAtTheJumpsAndNoneIsRejectedThere(double tolerance) {
    Integrator integrator = create(tolerance);
    List<Double> ends = new ArrayList<>();
    StepResult result = integrator.start(new Pushed(2.0, 1.0), 0, new double[2], 5);
    while (result == StepResult.ADVANCED) {
      long before = integrator.statistics().rejectedSteps();
      result = integrator.step();
      ends.add(integrator.time());
      if (ends.contains(1.0) && ends.size() > 1 && ends.get(ends.size() - 2) == 1.0) {
        assertThat(integrator.order()).isEqualTo(1);
      }
      if (integrator.time() == 1.0) {
        assertThat(integrator.statistics().rejectedSteps()).isEqualTo(before);
      }
    }
    assertThat(ends).contains(1.0, 2.0);
  }

  @Test
  void sidesOfAJumpAreNotMixed() {
    // Neither a value at the jump itself, nor one from beyond it, before it has been reached.
    Pushed pushed = new Pushed(1.0, 2.0);
    Integrator integrator = create(1e-6);
    StepResult result = integrator.start(pushed, 0, new double[2], 5);
    while (result == StepResult.ADVANCED) {
      double reached = integrator.time();
      pushed.evaluated.clear();
      result = integrator.step();
      for (double t : pushed.evaluated) {
        assertThat(t).isNotEqualTo(1.0).isNotEqualTo(2.0);
        assertThat(pushed.pushed(t)).isEqualTo(reached >= 1 && reached < 2);
      }
    }
    assertThat(result).isEqualTo(StepResult.REACHED_END);
  }

  @Test
  void valueAtTheJumpItselfDoesNotMatter() {
    Pushed rightAtTheJump = new Pushed(1.0, 2.0);
    Pushed leftAtTheJump =
        new Pushed(1.0, 2.0) {
          @Override
          boolean pushed(double t) {
            return t > 1 && t <= 2;
          }
        };
    double[] right = Run.of(create(1e-8), rightAtTheJump, 0, new double[2], 5).atEnd();
    double[] left = Run.of(create(1e-8), leftAtTheJump, 0, new double[2], 5).atEnd();
    assertThat(left).isEqualTo(right);
  }

  @Test
  void jumpsAreMetBackwardsInTime() {
    IntegratorSettings settings = tolerances(1e-10);
    double[] forth = Run.of(create(settings), new Pushed(1.0, 2.0), 0, new double[2], 5).atEnd();
    Run back = Run.of(create(settings), new Pushed(1.0, 2.0), 5, forth, 0);
    // Damped forth, so growing back: e^(0.2 · 5) on top of the error forth.
    assertThat(back.atEnd()).containsExactly(new double[] {0, 0}, within(1e-6));
  }

  @Test
  void jumpAtTheStartAndAtTheEndAndOutsideAreHarmless() {
    Pushed pushed = new Pushed(0.0, 1.0, 2.0, 5.0, 7.0, -3.0);
    Run run = Run.of(create(tolerances(1e-8)), pushed, 0, new double[2], 5);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(run.atEnd()).containsExactly(AT_END, within(1e-5));
  }

  @Test
  void lastPlaceIsNotSteppedOverEvenBeyondTheEnd() {
    // DE steps past the end, but not into a piece that begins there.
    Pushed pushed = new Pushed(1.0);
    Run run = Run.of(create(1e-3), pushed, 0, new double[2], 1);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(pushed.evaluated).isNotEmpty().allMatch(t -> t < 1);
  }

  @Test
  void runStoppedAtAJumpAndTakenUpAgainHasTheSameBits() {
    AtomicInteger asked = new AtomicInteger();
    IntegratorSettings stopping =
        new IntegratorSettings(
            1e-6,
            List.of(1e-6),
            Double.POSITIVE_INFINITY,
            0,
            0,
            Long.MAX_VALUE,
            () -> asked.incrementAndGet() % 3 == 0);
    Integrator integrator = create(stopping);
    integrator.start(new Pushed(1.0, 2.0), 0, new double[2], 5);
    StepResult result = StepResult.ADVANCED;
    while (result == StepResult.ADVANCED || result == StepResult.STOPPED) {
      result = integrator.step();
    }
    assertThat(Run.state(integrator, 5, 2))
        .isEqualTo(Run.of(create(1e-6), new Pushed(1.0, 2.0), 0, new double[2], 5).atEnd());
  }

  @Test
  void placeThatIsNotANumberIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> create(1e-6).start(new Pushed(Double.NaN), 0, new double[2], 5))
        .withMessageContaining("breakpoint is NaN");
  }
}
