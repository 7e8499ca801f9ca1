package org.mechservice.solver.spatial;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SinCosTest {
  /** 45 digits: more than the 33 that twice the working precision needs, for angles up to 1e4. */
  private static final MathContext DIGITS = new MathContext(45);

  private static final BigDecimal PI =
      new BigDecimal("3.14159265358979323846264338327950288419716939937510582097494459");

  @Test
  void errorStaysBelowOneUlpOverTheWholeFastRange() {
    Random random = new Random(20261121);
    double worst = 0;
    for (int i = 0; i < 4000; i++) {
      double angle = (2 * random.nextDouble() - 1) * StrictMath.pow(10, random.nextInt(-6, 5));
      worst = Math.max(worst, errorInUlps(angle));
    }
    assertThat(worst).isLessThan(1);
  }

  @ValueSource(
      doubles = {
        0,
        -0.0,
        Double.MIN_VALUE,
        1e-300,
        0.7853981633974483,
        -0.7853981633974484,
        1.5707963267948966,
        3.141592653589793,
        -4.71238898038469,
        6381.0 * 1.5707963267948966 - 30,
        9999.99999,
        -1e4
      })
  @ParameterizedTest
  void errorStaysBelowOneUlpWhereReductionIsHardest(double angle) {
    assertThat(errorInUlps(angle)).isLessThan(1);
  }

  @Test
  void anglesBeyondTheFastRangeAgreeWithStrictMath() {
    for (double angle : new double[] {1.0001e4, -3e7, 1e22, 1.7e308}) {
      double[] sc = new double[2];
      SinCos.sinCos(angle, sc, 0);
      assertThat(sc).containsExactly(StrictMath.sin(angle), StrictMath.cos(angle));
    }
  }

  @Test
  void whatIsNotFiniteGivesNaN() {
    for (double angle : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
      double[] sc = new double[2];
      SinCos.sinCos(angle, sc, 0);
      assertThat(sc).containsOnly(Double.NaN);
    }
  }

  @Test
  void writesAtTheOffsetOnly() {
    double[] sc = {7, 7, 7, 7};
    SinCos.sinCos(0, sc, 1);
    assertThat(sc).containsExactly(7, 0, 1, 7);
  }

  @Test
  void eachAloneHasTheBitsOfBoth() {
    Random random = new Random(5);
    double[] both = new double[2];
    for (int i = 0; i < 100_000; i++) {
      double angle = Math.pow(10, random.nextInt(12) - 5) * random.nextGaussian();
      SinCos.sinCos(angle, both, 0);
      assertThat(SinCos.sine(angle)).isEqualTo(both[0]);
      assertThat(SinCos.cosine(angle)).isEqualTo(both[1]);
    }
    assertThat(SinCos.sine(Double.NaN)).isNaN();
    assertThat(SinCos.cosine(Double.NEGATIVE_INFINITY)).isNaN();
  }

  private static double errorInUlps(double angle) {
    double[] sc = new double[2];
    SinCos.sinCos(angle, sc, 0);
    BigDecimal x = new BigDecimal(angle).remainder(PI.multiply(BigDecimal.valueOf(2)));
    return Math.max(
        ulps(sc[0], sine(x)), ulps(sc[1], sine(x.add(PI.divide(BigDecimal.valueOf(2))))));
  }

  private static double ulps(double value, BigDecimal exact) {
    double ulp = Math.max(Math.ulp(exact.doubleValue()), Double.MIN_NORMAL);
    return new BigDecimal(value).subtract(exact).abs().doubleValue() / ulp;
  }

  /** Taylor series; |x| ≤ 8, so 60 terms leave less than 1e-60. */
  private static BigDecimal sine(BigDecimal x) {
    MathContext work = new MathContext(DIGITS.getPrecision() + 20);
    BigDecimal square = x.multiply(x, work);
    BigDecimal term = x;
    BigDecimal sum = x;
    for (int n = 1; n <= 60; n++) {
      term = term.multiply(square, work).divide(BigDecimal.valueOf(-(2L * n) * (2L * n + 1)), work);
      sum = sum.add(term, work);
    }
    return sum.round(DIGITS);
  }
}
