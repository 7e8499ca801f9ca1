package org.mechservice.solver.ode.solve;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Linear systems with forces, events and intervals drawn at random: what is told in the course of a
 * run, kept of it, and found after it was cancelled and taken up again is the same to the bit.
 */
class RandomRunTest {
  private static final int RUNS = 60;

  private final Random random = new Random(21);

  private int n;
  private OdeProblem problem = Ode.system(0, (t, y, yDot) -> {});
  private OdeOptions options = OdeOptions.standard();
  private double t0;
  private double t1;
  private double[] y0 = {};

  private void draw(OdeMethod method) {
    n = 1 + random.nextInt(4);
    double[][] a = new double[n][n];
    for (double[] row : a) {
      Arrays.setAll(row, j -> random.nextGaussian());
    }
    a[0][0] -= random.nextInt(4) == 0 ? 300 : 1;
    double frequency = 1 + random.nextInt(5);
    problem =
        Ode.system(
            n,
            (t, y, yDot) -> {
              for (int i = 0; i < n; i++) {
                yDot[i] = StrictMath.sin(frequency * t + i);
                for (int j = 0; j < n; j++) {
                  yDot[i] += a[i][j] * y[j];
                }
              }
            });
    y0 = new double[n];
    Arrays.setAll(y0, i -> random.nextInt(5) == 0 ? 0 : random.nextGaussian());
    t0 = 10 * random.nextGaussian();
    boolean backwards = a[0][0] > -100 && random.nextBoolean();
    t1 = t0 + (backwards ? -1 : 1) * (0.5 + 2 * random.nextDouble());
    options =
        OdeOptions.standard()
            .method(method)
            .rtol(StrictMath.pow(10, -3 - random.nextInt(7)))
            .maxSteps(20000)
            .returnFailures();
    int events = random.nextInt(4);
    for (int e = 0; e < events; e++) {
      options = options.event(drawEvent());
    }
  }

  private OdeEvent drawEvent() {
    int k = random.nextInt(n);
    double level = random.nextInt(4) == 0 ? 0 : 0.5 * random.nextGaussian();
    double jump = random.nextGaussian();
    OdeEvent event = OdeEvent.when((t, y) -> y[k] - level);
    OdeEvent directed =
        switch (random.nextInt(3)) {
          case 0 -> event.rising();
          case 1 -> event.falling();
          default -> event;
        };
    return switch (random.nextInt(4)) {
      case 0 -> directed.then((t, y) -> y[k] += jump);
      case 1 -> directed.terminalAfter(1 + random.nextInt(4));
      case 2 -> directed.then((t, y) -> {});
      default -> directed;
    };
  }

  @ParameterizedTest
  @EnumSource
  void toldKeptAndResumedSolutionsAreTheSame(OdeMethod method) {
    int resumed = 0;
    for (int run = 0; run < RUNS; run++) {
      draw(method);
      List<Double> times = new ArrayList<>();
      List<double[]> told = new ArrayList<>();
      double distance = Math.abs(t1 - t0) / (1 + random.nextInt(40));
      OdeSolution solution =
          Ode.solve(
              problem,
              t0,
              y0,
              t1,
              options.outputEvery(
                  distance,
                  (t, y) -> {
                    times.add(t);
                    told.add(y.clone());
                  }));
      for (int i = 0; i < times.size(); i++) {
        assertThat(solution.at(times.get(i))).isEqualTo(told.get(i));
      }
      assertThat(solution.at(solution.start())).isEqualTo(solution.startState());
      assertThat(solution.at(solution.end())).isEqualTo(solution.endState());
      for (FoundEvent event : solution.events()) {
        assertThat(solution.at(event.time())).isEqualTo(event.after());
      }
      if (solution.endReason() != EndReason.FAILED && goesOnTheSame(solution)) {
        resumed++;
      }
    }
    // The place of the cut is drawn from all evaluations of the run: nearly every run is cut.
    assertThat(resumed).isGreaterThan(RUNS * 3 / 4);
  }

  /** Asserts that a run that is cut goes on the same; returns whether it was cut. */
  private boolean goesOnTheSame(OdeSolution whole) {
    AtomicLong asked = new AtomicLong();
    long limit = random.nextLong(1, Math.max(2, whole.statistics().evaluations()));
    OdeSolution part =
        Ode.solve(problem, t0, y0, t1, options.cancelWhen(() -> asked.incrementAndGet() > limit));
    if (part.endReason() == EndReason.CANCELLED) {
      OdeSolution rest = Ode.resume(problem, part.checkpoint(), options);
      assertThat(rest.endState()).isEqualTo(whole.endState());
      assertThat(rest.endReason()).isEqualTo(whole.endReason());
      assertThat(part.events().size() + rest.events().size()).isEqualTo(whole.events().size());
      return true;
    }
    return false;
  }
}
