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

/**
 * A force s(t) that jumps at random times, which no method is told of, beside smooth motion: steps
 * are of high order there, and a jump inside one passed the error test. Of 60 runs at 1e-3 with
 * jumps of a force beside cos t, 52 of ode113 and 54 of DE missed ten tolerances.
 */
class JumpOnCurvedSolutionTest {
  private static final int RUNS = 60;

  /** At most one run of sixty is wrong. */
  private static final int MOST_WRONG = 1;

  private static final double END = 10;

  /** Errors of some ten jumps add up, a tolerance or less each. */
  private static final double TOLERANCES = 10;

  /**
   * With jumps of any size the oscillation is larger, and its smooth stretches alone leave up to 17
   * tolerances (DE with the jumps declared, 1e-4).
   */
  private static final double LOOSE = 30;

  private static final double SHORTEST = 0.9;
  private static final double LONGEST = 1.9;

  /** The same where jumps follow closely: two in one step leave no trace at its ends. */
  private static final double CLOSE = 0.05;

  private static final double LESS_CLOSE = 0.5;

  /**
   * Of 60 runs up to 25 were wrong then; those are left in which two jumps lie in one step before
   * anything is known of them.
   */
  private static final int MOST_WRONG_WHERE_CLOSE = 3;

  /** ode15s, which is not held to a part of the tolerances where nothing but a decay is fast. */
  private static final int MOST_WRONG_BY_ODE15S = 6;

  /** Times at which s jumps, and its values before the first one, between and behind. */
  @SuppressWarnings("ArrayRecordComponent") // compared by nobody
  private record Force(double[] times, double[] values) {
    static Force random(long seed, boolean inTurns, boolean close) {
      Random random = new Random(seed);
      double shortest = close ? CLOSE : SHORTEST;
      double longest = close ? LESS_CLOSE : LONGEST;
      double[] times = new double[(int) (END / shortest) + 2];
      double[] values = new double[times.length + 1];
      double sign = random.nextBoolean() ? 1 : -1;
      for (int i = 0; i < values.length; i++) {
        boolean positive = close ? random.nextBoolean() : i % 2 == 0;
        values[i] = inTurns ? (positive ? sign : -sign) : 3 * (2 * random.nextDouble() - 1);
      }
      double t = 0;
      for (int i = 0; i < times.length; i++) {
        t += shortest + (longest - shortest) * random.nextDouble();
        times[i] = t;
      }
      return new Force(times, values);
    }

    double at(double t) {
      int found = Arrays.binarySearch(times, t);
      return values[found < 0 ? -found - 1 : found];
    }
  }

  /** Motions under a force, each with its solution over a stretch of constant force. */
  private enum Motion {
    DECAY(1) {
      @Override
      OdeFunction under(Force force) {
        return (t, y, yDot) -> yDot[0] = force.at(t) - y[0];
      }

      @Override
      void move(double[] y, double from, double to, double s) {
        y[0] = s + (y[0] - s) * StrictMath.exp(from - to);
      }
    },
    OSCILLATION(2) {
      @Override
      OdeFunction under(Force force) {
        return (t, y, yDot) -> {
          yDot[0] = y[1];
          yDot[1] = force.at(t) - 4 * y[0];
        };
      }

      @Override
      void move(double[] y, double from, double to, double s) {
        double cosine = StrictMath.cos(2 * (to - from));
        double sine = StrictMath.sin(2 * (to - from));
        double off = y[0] - 0.25 * s;
        double speed = y[1];
        y[0] = 0.25 * s + off * cosine + 0.5 * speed * sine;
        y[1] = speed * cosine - 2 * off * sine;
      }
    };

    final int dimension;

    Motion(int dimension) {
      this.dimension = dimension;
    }

    abstract OdeFunction under(Force force);

    abstract void move(double[] y, double from, double to, double s);
  }

  @ParameterizedTest
  @EnumSource(names = {"ODE113", "DE", "ODE15S", "AUTO"})
  void changesOfSignAreNotSteppedOver(OdeMethod method) {
    for (Motion motion : Motion.values()) {
      for (double tolerance : new double[] {1e-3, 1e-4, 1e-6}) {
        assertThat(wrong(method, motion, true, false, tolerance, TOLERANCES))
            .as("%s at %.0e", motion, tolerance)
            .isLessThanOrEqualTo(MOST_WRONG);
      }
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"ODE113", "DE", "ODE15S", "AUTO"})
  void jumpsOfAnySizeAreNotSteppedOver(OdeMethod method) {
    for (Motion motion : Motion.values()) {
      for (double tolerance : new double[] {1e-3, 1e-4, 1e-6}) {
        assertThat(wrong(method, motion, false, false, tolerance, LOOSE))
            .as("%s at %.0e", motion, tolerance)
            .isLessThanOrEqualTo(MOST_WRONG);
      }
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"ODE113", "DE", "ODE15S", "AUTO"})
  void jumpsThatFollowCloselyAreRarelySteppedOver(OdeMethod method) {
    int most = method == OdeMethod.ODE15S ? MOST_WRONG_BY_ODE15S : MOST_WRONG_WHERE_CLOSE;
    for (double tolerance : new double[] {1e-3, 1e-4, 1e-6}) {
      assertThat(wrong(method, Motion.DECAY, true, true, tolerance, TOLERANCES))
          .as("at %.0e", tolerance)
          .isLessThanOrEqualTo(most);
    }
  }

  private static int wrong(
      OdeMethod method,
      Motion motion,
      boolean inTurns,
      boolean close,
      double tolerance,
      double tolerances) {
    OdeOptions options =
        OdeOptions.standard()
            .searchUndeclaredJumps()
            .rtol(tolerance)
            .atol(tolerance)
            .method(method)
            .keepSteps(false);
    int wrong = 0;
    for (int seed = 0; seed < RUNS; seed++) {
      Force force = Force.random(seed, inTurns, close);
      double[] start = new double[motion.dimension];
      double[] end = Ode.solve(motion.under(force), 0, start, END, options).endState();
      double[] exact = new double[motion.dimension];
      double scale = 1;
      double from = 0;
      for (int i = 0; from < END; i++) {
        double to = Math.min(END, force.times[i]);
        motion.move(exact, from, to, force.values[i]);
        from = to;
        scale = Math.max(scale, Math.abs(exact[exact.length - 1]));
      }
      double error = 0;
      for (int l = 0; l < exact.length; l++) {
        error = Math.max(error, Math.abs(end[l] - exact[l]));
      }
      wrong += error > tolerances * tolerance * scale ? 1 : 0;
    }
    return wrong;
  }
}
