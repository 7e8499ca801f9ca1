package org.mechservice.mechml.resolve.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class RestitutionTest {
  static LongStream seeds() {
    return LongStream.rangeClosed(1, 40);
  }

  /**
   * An impact by classical Runge-Kutta steps, some 20 000 of them: its error is 1e-9 at most, and
   * the force has a corner only at the touch.
   */
  @MethodSource("seeds")
  @ParameterizedTest
  void impactLeavesWithTheRestitutionAskedFor(long seed) {
    Random random = new Random(seed);
    double e = 0.05 + 0.95 * random.nextDouble();
    double n = 1 + 2 * random.nextDouble();
    double k = Math.exp(10 * random.nextDouble());
    double v = Math.exp(4 * random.nextDouble() - 2);
    double chi = Restitution.dissipationBySpeed(e) / v;
    assertThat(rebound(k, n, chi, v)).isCloseTo(e * v, within(1e-6 * v));
  }

  /** Returns the speed at which a body of 1 kg leaves after it has hit with the speed v. */
  private static double rebound(double k, double n, double chi, double v) {
    double depth = Math.pow((n + 1) * v * v / (2 * k), 1 / (n + 1));
    double h = depth / v / 5000;
    double x = 0;
    double u = v;
    double before = 0;
    double speedBefore = 0;
    while (x >= 0) {
      before = x;
      speedBefore = u;
      double a1 = pull(k, n, chi, x, u);
      double u2 = u + 0.5 * h * a1;
      double a2 = pull(k, n, chi, x + 0.5 * h * u, u2);
      double u3 = u + 0.5 * h * a2;
      double a3 = pull(k, n, chi, x + 0.5 * h * u2, u3);
      double u4 = u + h * a3;
      double a4 = pull(k, n, chi, x + h * u3, u4);
      x += h / 6 * (u + 2 * u2 + 2 * u3 + u4);
      u += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    double share = before / (before - x);
    return -(speedBefore + share * (u - speedBefore));
  }

  private static double pull(double k, double n, double chi, double x, double u) {
    return x <= 0 ? 0 : -k * Math.pow(x, n) * Math.max(0, 1 + chi * u);
  }

  @Test
  void elasticImpactNeedsNoDissipation() {
    assertThat(Restitution.dissipationBySpeed(1)).isZero();
  }

  /** The limits of the two published formulas: 3 (1 - e²)/4 for e = 1, and 1/e for e = 0. */
  @Test
  void limitsAreThoseOfTheEquation() {
    for (double e : new double[] {1 - 1e-3, 1 - 1e-6, 1 - 1e-9, 1 - 1e-12}) {
      assertThat(Restitution.dissipationBySpeed(e) / (0.75 * (1 - e * e)))
          .isCloseTo(1, within(2 * (1 - e) + 1e-4 * (1 - e) + 1e-3));
    }
    assertThat(Restitution.dissipationBySpeed(0.01)).isCloseTo(100, within(1e-9));
  }
}
