package org.mechservice.solver.force.law;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SmoothPositiveTest {
  /** Differences with step 1e-5 of functions that bend over 0.01: 1e-9 relative. */
  @CsvSource({"-0.3", "-0.01", "-0.001", "0", "0.002", "0.05", "2"})
  @ParameterizedTest
  void slopeBendAndIntegralAreDerivatives(double x) {
    double eps = 0.01;
    double h = 1e-5;
    double slope = (SmoothPositive.value(x + h, eps) - SmoothPositive.value(x - h, eps)) / (2 * h);
    double bend = (SmoothPositive.slope(x + h, eps) - SmoothPositive.slope(x - h, eps)) / (2 * h);
    assertThat(SmoothPositive.slope(x, eps)).isCloseTo(slope, within(2e-6 * slope + 1e-10));
    assertThat(SmoothPositive.bend(x, eps)).isCloseTo(bend, within(2e-6 * 50));
    for (double n : new double[] {1, 1.5, 2, 3.3}) {
      double difference =
          (SmoothPositive.integral(x + h, eps, n) - SmoothPositive.integral(x - h, eps, n))
              / (2 * h);
      double expected = Math.pow(SmoothPositive.value(x, eps), n);
      assertThat(difference).isCloseTo(expected, within(1e-5 * expected + 1e-11));
    }
  }

  @ValueSource(doubles = {1, 1.5, 2})
  @ParameterizedTest
  void sharpPositivePartIsTheLimit(double n) {
    assertThat(SmoothPositive.value(-3, 0)).isZero();
    assertThat(SmoothPositive.value(3, 0)).isEqualTo(3);
    assertThat(SmoothPositive.slope(3, 0)).isEqualTo(1);
    assertThat(SmoothPositive.slope(-3, 0)).isZero();
    assertThat(SmoothPositive.slope(0, 0)).isEqualTo(0.5);
    assertThat(SmoothPositive.integral(-1, 0, n)).isZero();
    assertThat(SmoothPositive.integral(2, 0, n))
        .isCloseTo(Math.pow(2, n + 1) / (n + 1), within(1e-14));
  }

  /** Naively (x + √(x² + ε²)) / 2 is 0 there: all its digits cancel. */
  @Test
  void farBelowZeroKeepsItsDigits() {
    assertThat(SmoothPositive.value(-1, 1e-9)).isCloseTo(2.5e-19, within(1e-33));
  }
}
