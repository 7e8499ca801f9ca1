package org.mechservice.solver.ode.jumps;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.ode.solve.Ode;
import org.mechservice.solver.ode.solve.OdeFunction;
import org.mechservice.solver.ode.solve.OdeMethod;
import org.mechservice.solver.ode.solve.OdeOptions;

/** A right-hand side that jumps to and fro at random times, which no method is told of. */
class RandomPulseTest {
  private static final int RUNS = 60;

  /** At most one run of sixty is off by more than a thousand tolerances. */
  private static final int MOST_WRONG = 1;

  private static final double SHORTEST = 0.05;
  private static final double LONGEST = 0.5;

  /** A pair of jumps that is missed changes the end by twice its distance, all but a bit. */
  private static final double LEAST_MISSED = 1.8 * SHORTEST;

  /** y' = 1 and −1, in turns or as it happens. */
  private static final class Turns implements OdeFunction {
    private final double[] places;
    private final double[] slopes;

    Turns(double[] places, double[] slopes) {
      this.places = places;
      this.slopes = slopes;
    }

    static Turns random(long seed, boolean inTurns) {
      Random random = new Random(seed);
      double[] places = new double[300];
      double[] slopes = new double[places.length + 1];
      for (int i = 0; i < slopes.length; i++) {
        slopes[i] = (inTurns ? i % 2 == 0 : random.nextBoolean()) ? 1 : -1;
      }
      double t = 0;
      for (int i = 0; i < places.length; i++) {
        t += SHORTEST + (LONGEST - SHORTEST) * random.nextDouble();
        places[i] = t;
      }
      return new Turns(places, slopes);
    }

    private int before(double t) {
      int found = Arrays.binarySearch(places, t);
      return found < 0 ? -found - 1 : found;
    }

    @Override
    public void evaluate(double t, double[] y, double[] yDot) {
      yDot[0] = slopes[before(t)];
    }

    double integral(double end) {
      double sum = 0;
      double from = 0;
      for (int i = 0; from < end; i++) {
        double to = Math.min(end, places[i]);
        sum += slopes[i] * (to - from);
        from = to;
      }
      return sum;
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"ODE113", "DE", "ODE15S", "AUTO"})
  void jumpsToAndFroAtRandomTimesAreAllSeen(OdeMethod method) {
    count(method, true, 10);
  }

  @ParameterizedTest
  @EnumSource(names = {"ODE113", "DE", "ODE15S", "AUTO"})
  void jumpsOfAnySignAreAllSeenInShortRunsAndLongOnes(OdeMethod method) {
    count(method, false, 2);
    count(method, false, 10);
  }

  private static void count(OdeMethod method, boolean inTurns, double tEnd) {
    for (double tolerance : new double[] {1e-3, 1e-4, 1e-6, 1e-9}) {
      OdeOptions options =
          OdeOptions.standard()
              .searchUndeclaredJumps()
              .rtol(tolerance)
              .atol(tolerance)
              .method(method);
      int wrong = 0;
      for (int seed = 0; seed < RUNS; seed++) {
        Turns turns = Turns.random(seed, inTurns);
        double end = Ode.solve(turns, 0, new double[] {0}, tEnd, options).endState()[0];
        wrong +=
            Math.abs(end - turns.integral(tEnd)) > Math.min(LEAST_MISSED, 1000 * tolerance) ? 1 : 0;
      }
      assertThat(wrong).as("tolerance %s", tolerance).isLessThanOrEqualTo(MOST_WRONG);
    }
  }
}
