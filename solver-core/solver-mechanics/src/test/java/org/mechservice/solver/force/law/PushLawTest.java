package org.mechservice.solver.force.law;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import java.util.Random;
import java.util.function.IntFunction;
import java.util.stream.LongStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/**
 * A push with random coefficients, smooth and not, with every kind of damping, as a formula of the
 * coefficients and with their numbers in place.
 */
class PushLawTest {
  private static final int STATES = 200;

  /** Coefficients of a law. */
  private record Draw(double k, double n, double c, double chi, double eps, Random random) {
    static Draw of(long seed) {
      Random random = new Random(seed);
      double k = random.nextInt(5) == 0 ? 0 : Math.exp(8 * random.nextDouble());
      double n = random.nextBoolean() ? 1 : 1 + 2 * random.nextDouble();
      double c = random.nextInt(3) == 0 ? 0 : Math.exp(8 * random.nextDouble());
      double chi = random.nextBoolean() ? 0 : 10 * random.nextDouble();
      double eps = random.nextInt(3) == 0 ? 0 : Math.exp(-9 * random.nextDouble());
      return new Draw(k, n, c, chi, eps, random);
    }

    Push law() {
      return new Push(this);
    }

    /** A depth, near zero and far from it, on both sides. */
    double depth() {
      return random.nextGaussian() * (random.nextBoolean() ? 1 : 3 * eps + 1e-3);
    }

    double rate() {
      return random.nextGaussian() * Math.exp(4 * random.nextGaussian());
    }
  }

  static LongStream seeds() {
    return LongStream.rangeClosed(1, 60);
  }

  @MethodSource("seeds")
  @ParameterizedTest
  void neverPulls(long seed) {
    Draw draw = Draw.of(seed);
    Push law = draw.law();
    for (int i = 0; i < STATES; i++) {
      law.evaluate(draw.depth(), draw.rate());
      assertThat(law.force() >= 0).as("force %s", law.force()).isTrue();
      assertThat(law.elastic() >= 0).as("elastic part %s", law.elastic()).isTrue();
    }
  }

  /** What the force does beside its elastic part is against the motion. */
  @MethodSource("seeds")
  @ParameterizedTest
  void damperOnlyLosesEnergy(long seed) {
    Draw draw = Draw.of(seed);
    Push law = draw.law();
    for (int i = 0; i < STATES; i++) {
      double rate = draw.rate();
      law.evaluate(draw.depth(), rate);
      double lost = (law.force() - law.elastic()) * rate;
      assertThat(lost >= 0).as("power of the damper %s", lost).isTrue();
    }
  }

  /** Where the damper takes away less than half of the push, the law is the sum itself. */
  @MethodSource("seeds")
  @ParameterizedTest
  void isTheSumWhereTheDamperTakesLessThanHalf(long seed) {
    Draw draw = Draw.of(seed);
    Push law = draw.law();
    int compared = 0;
    for (int i = 0; i < STATES; i++) {
      double x = draw.depth();
      double rate = draw.rate();
      law.evaluate(x, rate);
      double elastic = draw.k() * Math.pow(positive(x, draw.eps()), draw.n());
      double damper = draw.c() * rate * slope(x, draw.eps()) + draw.chi() * rate * elastic;
      if (damper >= -elastic / 2) {
        assertThat(law.force())
            .isCloseTo(elastic + damper, within(1e-13 * (elastic + Math.abs(damper))));
        compared++;
      }
    }
    // Half of the rates go into the contact, where the damper adds to the push; 200 draws of even
    // odds fall below a third with a probability of 1e-6.
    assertThat(compared).isGreaterThan(STATES / 3);
  }

  /**
   * Central differences over 1e-6 of the size of the argument: a share of 1e-8 of the largest slope
   * nearby, away from the corners of a law without smoothing.
   */
  @MethodSource("seeds")
  @ParameterizedTest
  void slopesAreDifferences(long seed) {
    Draw draw = Draw.of(seed);
    Push law = draw.law();
    int compared = 0;
    for (int i = 0; i < STATES; i++) {
      double x = draw.depth();
      double rate = draw.rate();
      double hx = 1e-6 * Math.max(draw.eps(), Math.abs(x));
      double hv = 1e-6 * Math.abs(rate);
      law.evaluate(x, rate);
      double force = law.force();
      double byDepth = law.byDepth();
      double byRate = law.byRate();
      if (draw.eps() == 0 && (x < 0) != (x - hx < 0)) {
        continue;
      }
      double up = force(law, x + hx, rate);
      double down = force(law, x - hx, rate);
      double faster = force(law, x, rate + hv);
      double slower = force(law, x, rate - hv);
      boolean corner =
          (up == 0) != (down == 0) || (faster == 0) != (slower == 0) || (force == 0 && up != 0);
      if (!corner) {
        double scale = (Math.abs(force) + law.elastic()) * 1e-9;
        assertThat((up - down) / (2 * hx))
            .isCloseTo(byDepth, within(1e-6 * Math.abs(byDepth) + scale / hx));
        assertThat((faster - slower) / (2 * hv))
            .isCloseTo(byRate, within(1e-6 * Math.abs(byRate) + scale / hv));
        compared++;
      }
    }
    // A corner lies within 1e-6 of a state in few of the draws.
    assertThat(compared).isGreaterThan(STATES * 9 / 10);
  }

  private static double force(Push law, double x, double rate) {
    law.evaluate(x, rate);
    return law.force();
  }

  private static double positive(double x, double eps) {
    double root = Math.sqrt(x * x + eps * eps);
    return x >= 0 ? 0.5 * (x + root) : eps == 0 ? 0 : 0.5 * eps * (eps / (root - x));
  }

  private static double slope(double x, double eps) {
    double root = Math.sqrt(x * x + eps * eps);
    return root == 0 ? 0.5 : positive(x, eps) / root;
  }

  /** The law as programs; both forms must agree in all that they put out. */
  private static final class Push {
    private final Program general = new Program();
    private final Program folded = new Program();
    private final double[] inputs = new double[7];
    private final double[] out = new double[4];

    Push(Draw draw) {
      double[] c = {draw.k(), draw.n(), draw.c(), draw.chi(), draw.eps()};
      System.arraycopy(c, 0, inputs, 2, c.length);
      put(general, i -> general.expressions().input(2 + i));
      put(folded, i -> folded.expressions().constant(c[i]));
    }

    private static void put(Program program, IntFunction<Scalar> c) {
      program.section("Push.", "push");
      Expressions e = program.expressions();
      PushLaw law = new PushLaw(c.apply(0), c.apply(1), c.apply(2), c.apply(3), c.apply(4));
      Scalar x = e.input(0);
      Scalar rate = e.input(1);
      Scalar force = law.force(x, rate);
      program.output(0, force);
      program.output(1, law.elastic(x));
      program.output(2, new Differentiation(e, Map.of(x, e.one())).of(force));
      program.output(3, new Differentiation(e, Map.of(rate, e.one())).of(force));
    }

    /** Bound: some ten operations in another order, on terms of the size of the elastic part. */
    void evaluate(double x, double rate) {
      inputs[0] = x;
      inputs[1] = rate;
      double[] other = new double[4];
      general.evaluate(inputs, out);
      folded.evaluate(inputs, other);
      for (int i = 0; i < out.length; i++) {
        assertThat(out[i])
            .as("output %d at %s, %s", i, x, rate)
            .isCloseTo(other[i], within(1e-14 * (Math.abs(other[i]) + Math.abs(out[1]))));
      }
    }

    double force() {
      return out[0];
    }

    double elastic() {
      return out[1];
    }

    double byDepth() {
      return out[2];
    }

    double byRate() {
      return out[3];
    }
  }
}
