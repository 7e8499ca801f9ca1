package org.mechservice.solver.force.law;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.printed.PrintedLaws;
import org.mechservice.solver.symbol.MathFunction;

/** The closest point of formulas against minimisation by brute force. */
class ClosestPointTest {
  private static final double RADIUS = 0.3;
  private static final Expression S = new Expression.Argument();

  static LongStream seeds() {
    return LongStream.rangeClosed(1, 200);
  }

  private static Expression times(double factor, Expression e) {
    return new Expression.Product(Expression.of(factor), e);
  }

  private static Expression wave(double high, double rate) {
    return times(high, Expression.call(MathFunction.SIN, List.of(times(rate, S))));
  }

  private static Expression bump(double high, double width) {
    Expression part = times(1 / width, S);
    Expression square = new Expression.Negation(new Expression.Product(part, part));
    return times(high, Expression.call(MathFunction.EXP, List.of(square)));
  }

  private static double least(DoubleUnaryOperator h, double x, double z) {
    DoubleUnaryOperator distance = s -> Math.hypot(s - x, h.applyAsDouble(s) - z);
    double step = RADIUS / 2000;
    double best = x;
    for (double s = x - 2 * RADIUS; s < x + 2 * RADIUS; s += step) {
      best = distance.applyAsDouble(s) < distance.applyAsDouble(best) ? s : best;
    }
    double low = best - step;
    double high = best + step;
    for (int k = 0; k < 100; k++) {
      double one = low + (high - low) * 0.382;
      double two = low + (high - low) * 0.618;
      boolean left = distance.applyAsDouble(one) < distance.applyAsDouble(two);
      low = left ? low : one;
      high = left ? two : high;
    }
    return distance.applyAsDouble(0.5 * (low + high));
  }

  /** Waves and bumps, also such that bend more than the sphere, of a quarter of it or wider. */
  @MethodSource("seeds")
  @ParameterizedTest
  void distanceIsTheLeastWithinReach(long seed) {
    Random random = new Random(seed);
    double high = 0.15 * random.nextGaussian();
    double width = RADIUS * (0.4 + 3 * random.nextDouble());
    boolean isWave = random.nextBoolean();
    Expression curve = isWave ? wave(high, 2 / width) : bump(high, width);
    DoubleUnaryOperator h =
        isWave
            ? s -> high * StrictMath.sin(2 / width * s)
            : s -> high * StrictMath.exp(-(s / width) * (s / width));
    Foot point = new Foot(curve);
    for (int i = 0; i < 40; i++) {
      double x = random.nextGaussian() * width;
      double z = h.applyAsDouble(x) + 1.9 * RADIUS * random.nextDouble();
      assertThat(point.find(x, z)).isTrue();
      double expected = least(h, x, z);
      assertThat(point.distance())
          .as("seed %d, (%s, %s)", seed, x, z)
          .isCloseTo(expected, within(1e-12));
    }
  }

  /** The normal turns as its derivative says, where the closest point moves evenly. */
  @MethodSource("seeds")
  @ParameterizedTest
  void normalTurnsAsTheClosestPointMoves(long seed) {
    Random random = new Random(seed);
    Foot point = new Foot(wave(0.03, 2 + random.nextDouble()));
    double x = 3 * random.nextGaussian();
    double z = RADIUS + 0.05 * random.nextGaussian();
    point.find(x - 1e-6, z);
    double before = Math.atan2(point.sine(), point.cosine());
    point.find(x + 1e-6, z);
    double behind = Math.atan2(point.sine(), point.cosine());
    point.find(x, z);
    double turn = point.turn();
    assertThat((behind - before) / 2e-6).isCloseTo(turn, within(1e-6 * (1 + Math.abs(turn))));
  }

  /** Far above hollows of any width the gap is positive, and nothing is refused. */
  @Test
  void farAboveNothingIsRefused() {
    Foot point = new Foot(wave(0.2, 30));
    for (double z = 0.6; z < 100; z *= 1.1) {
      for (double x = 0; x < 0.3; x += 0.01) {
        assertThat(point.find(x, z)).isTrue();
        assertThat(point.distance()).isGreaterThanOrEqualTo(z - 0.2);
      }
    }
  }

  /** A corner pushes towards the centre of the sphere. */
  @Test
  void cornerPushesTowardsTheCentre() {
    Expression roof =
        new Expression.Negation(Expression.call(MathFunction.ABS, List.of(times(0.8, S))));
    Foot point = new Foot(roof);
    double x = 0.1;
    double z = 0.25;
    assertThat(point.find(x, z)).isTrue();
    double expected = Math.hypot(x, z);
    assertThat(point.distance()).isCloseTo(expected, within(1e-14));
    assertThat(point.sine()).isCloseTo(-x / expected, within(1e-12));
  }

  /**
   * What the search finds, with distance and normal from the printed contact of a frozen motion.
   */
  private static final class Foot {
    private static final int PUSH = 3;

    private final ClosestPoint point;
    private final PrintedLaw law = PrintedLaws.of(PairLaw.CONTACT, false);
    private final double[] motion = new double[PairLaw.VARIABLES];
    private final double[] c = new double[law.size()];
    private final double[] load = new double[PairLaw.DIRECTION + 1];
    private final double[] slopes = new double[72];
    private final double[] results = new double[PairLaw.VALUES + 4];

    Foot(Expression curve) {
      point = new ClosestPoint(curve);
      // a stiffness and an exponent of one; a radius that is deep in the surface everywhere
      c[0] = 1e3;
      c[1] = 1;
      c[4] = 1;
      law.settle(c, c);
    }

    boolean find(double x, double z) {
      boolean found = point.find(x, z);
      motion[0] = x;
      motion[2] = z;
      point.curve(c, PairLaw.FOOT);
      law.load(motion, c, load);
      law.slopes(motion, c, slopes);
      law.results(motion, c, results);
      return found;
    }

    double distance() {
      c[0] = 0;
      law.settle(c, c);
      law.results(motion, c, results);
      c[0] = 1e3;
      law.settle(c, c);
      return -results[PairLaw.VALUES];
    }

    double sine() {
      return -load[PUSH] / Math.hypot(load[PUSH], load[PUSH + 2]);
    }

    double cosine() {
      return load[PUSH + 2] / Math.hypot(load[PUSH], load[PUSH + 2]);
    }

    /** Returns dθ/dx from the slopes of the push (−N sin θ, N cos θ). */
    double turn() {
      double byX = slopes[6 * PUSH + PUSH];
      double upByX = slopes[6 * (PUSH + 2) + PUSH];
      return -(byX * cosine() + upByX * sine()) / Math.hypot(load[PUSH], load[PUSH + 2]);
    }
  }
}
