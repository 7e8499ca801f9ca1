package org.mechservice.solver.force.law;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.BiFunction;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

class SmoothPartTest {
  /** Differences with step 1e-5 of functions that bend over 0.01: 1e-9 relative. */
  @CsvSource({"-0.3", "-0.01", "-0.001", "0", "0.002", "0.05", "2"})
  @ParameterizedTest
  void slopeAndIntegralAreDerivatives(double x) {
    double eps = 0.01;
    double h = 1e-5;
    double slope = (value(x + h, eps) - value(x - h, eps)) / (2 * h);
    assertThat(slope(x, eps)).isCloseTo(slope, within(2e-6 * slope + 1e-10));
    for (double n : new double[] {1, 1.5, 2, 3.3}) {
      double difference = (integral(x + h, eps, n) - integral(x - h, eps, n)) / (2 * h);
      double expected = Math.pow(value(x, eps), n);
      assertThat(difference).isCloseTo(expected, within(1e-5 * expected + 1e-11));
    }
  }

  @ValueSource(doubles = {1, 1.5, 2})
  @ParameterizedTest
  void sharpPositivePartIsTheLimit(double n) {
    assertThat(value(-3, 0)).isZero();
    assertThat(value(3, 0)).isEqualTo(3);
    assertThat(integral(-1, 0, n)).isZero();
    assertThat(integral(2, 0, n)).isCloseTo(Math.pow(2, n + 1) / (n + 1), within(1e-14));
  }

  /** Naively (x + √(x² + ε²)) / 2 is 0 there: all its digits cancel. */
  @Test
  void farBelowZeroKeepsItsDigits() {
    assertThat(value(-1, 1e-9)).isCloseTo(2.5e-19, within(1e-33));
  }

  private static double value(double x, double eps) {
    return evaluated(x, eps, 1, (part, n) -> part.value());
  }

  private static double slope(double x, double eps) {
    return evaluated(x, eps, 1, (part, n) -> part.slope());
  }

  private static double integral(double x, double eps, double n) {
    return evaluated(x, eps, n, SmoothPart::integral);
  }

  /** Returns a value of the formula of ε and n, which must be that with their numbers in place. */
  private static double evaluated(
      double x, double eps, double n, BiFunction<SmoothPart, Scalar, Scalar> part) {
    double general = evaluated(part, e -> e.input(1), e -> e.input(2), new double[] {x, eps, n});
    double folded = evaluated(part, e -> e.constant(eps), e -> e.constant(n), new double[] {x});
    // some ten operations, in another order
    assertThat(general).isCloseTo(folded, within(1e-14 * Math.abs(folded)));
    return folded;
  }

  private static double evaluated(
      BiFunction<SmoothPart, Scalar, Scalar> part,
      Function<Expressions, Scalar> eps,
      Function<Expressions, Scalar> n,
      double[] inputs) {
    Program program = new Program();
    Expressions e = program.expressions();
    program.section("Part.", "part");
    program.output(0, part.apply(new SmoothPart(e.input(0), eps.apply(e)), n.apply(e)));
    double[] out = new double[1];
    program.evaluate(inputs, out);
    return out[0];
  }
}
