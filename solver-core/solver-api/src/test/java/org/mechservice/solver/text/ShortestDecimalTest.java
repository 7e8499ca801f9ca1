package org.mechservice.solver.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ShortestDecimalTest {
  @CsvSource({
    "0, 0",
    "-0.0, -0",
    "1, 1",
    "-2.5, -2.5",
    "0.1, 0.1",
    "0.07, 0.07",
    "0.00123, 0.00123",
    "0.00001, 1e-5",
    "0.000001, 1e-6",
    "123456789012345680, 1.2345678901234568e17",
    "12345678901234568, 12345678901234568",
    "100, 100",
    "2e23, 2e23",
    "4.9e-324, 5e-324",
    "2.2250738585072014e-308, 2.2250738585072014e-308",
    "1.7976931348623157e308, 1.7976931348623157e308",
    "9007199254740993, 9007199254740992",
    "5e-324, 5e-324",
    "1e22, 1e22",
    "1e23, 1e23"
  })
  @ParameterizedTest
  void writesPlainlyWhereThatIsShortAndWithAnExponentElsewhere(double value, String text) {
    assertThat(ShortestDecimal.format(value)).isEqualTo(text);
  }

  @Test
  void readsBackExactlyAndNoShorterDecimalDoes() {
    hardValues()
        .forEach(
            value -> {
              BigDecimal written = new BigDecimal(ShortestDecimal.format(value));
              assertThat(written.doubleValue()).isEqualTo(value);
              assertThat(digits(written)).isEqualTo(fewestDigits(value));
            });
  }

  @Test
  void isTheNearestAmongTheDecimalsOfItsLength() {
    AtomicInteger compared = new AtomicInteger();
    hardValues()
        .forEach(
            value -> {
              BigDecimal exact = new BigDecimal(value);
              BigDecimal written = new BigDecimal(ShortestDecimal.format(value));
              BigDecimal unit = written.stripTrailingZeros().ulp();
              BigDecimal error = exact.subtract(written).abs();
              for (BigDecimal other :
                  new BigDecimal[] {written.add(unit), written.subtract(unit)}) {
                if (other.doubleValue() == value) {
                  assertThat(error).isLessThanOrEqualTo(exact.subtract(other).abs());
                  compared.incrementAndGet();
                }
              }
            });
    // Half of the random doubles need 17 digits, and most of them have several decimals of 17.
    assertThat(compared.get()).isGreaterThan(1000);
  }

  @Test
  void refusesWhatIsNotFinite() {
    assertThatThrownBy(() -> ShortestDecimal.format(Double.NaN))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("NaN");
  }

  /**
   * Random bit patterns, numbers of everyday size, powers of two (uneven neighbours) and
   * subnormals.
   */
  private static DoubleStream hardValues() {
    Random random = new Random(20030810);
    DoubleStream patterns =
        DoubleStream.generate(() -> Double.longBitsToDouble(random.nextLong()))
            .filter(Double::isFinite)
            .limit(5000);
    DoubleStream everyday = random.doubles(5000, -10, 10);
    DoubleStream powers =
        DoubleStream.iterate(Double.MIN_VALUE, x -> x < Double.POSITIVE_INFINITY, x -> 2 * x);
    DoubleStream subnormals = random.longs(1000, 1, 1L << 52).mapToDouble(Double::longBitsToDouble);
    return DoubleStream.concat(
        DoubleStream.concat(patterns, everyday), DoubleStream.concat(powers, subnormals));
  }

  private static int digits(BigDecimal number) {
    return number.stripTrailingZeros().precision();
  }

  private static int fewestDigits(double value) {
    BigDecimal exact = new BigDecimal(value);
    for (int digits = 1; digits < 17; digits++) {
      for (RoundingMode mode : new RoundingMode[] {RoundingMode.DOWN, RoundingMode.UP}) {
        if (exact.round(new MathContext(digits, mode)).doubleValue() == value) {
          return digits;
        }
      }
    }
    return 17;
  }
}
