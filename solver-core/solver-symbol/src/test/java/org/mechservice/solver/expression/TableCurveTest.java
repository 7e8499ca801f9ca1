package org.mechservice.solver.expression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.expression.Table.Extrapolation;
import org.mechservice.solver.expression.Table.Method;

/** Curves of tables: laws of their methods, and their derivatives. */
class TableCurveTest {
  private static final double[] X = {-1, 0.3, 0.5, 1.7, 2, 3.1};

  private static TableCurve curve(
      DoubleUnaryOperator y, Method method, Extrapolation outside, double... x) {
    return table(y, method, outside, x).curve();
  }

  private static Table table(
      DoubleUnaryOperator y, Method method, Extrapolation outside, double... x) {
    List<Double> arguments = DoubleStream.of(x).boxed().toList();
    List<Double> values = DoubleStream.of(x).map(y).boxed().toList();
    return new Table("f", arguments, values, method, outside);
  }

  @Test
  void splineIsExactForCubics() {
    DoubleUnaryOperator cubic = x -> 1 - 2 * x + 0.5 * x * x + 3 * x * x * x;
    TableCurve curve = curve(cubic, Method.CUBIC, Extrapolation.HOLD, X);
    for (double x = -1; x < 3.1; x += 0.01) {
      assertThat(curve.at(x)).isCloseTo(cubic.applyAsDouble(x), within(1e-12));
    }
    TableCurve of4 = curve(cubic, Method.CUBIC, Extrapolation.HOLD, 0, 1, 1.5, 4);
    assertThat(of4.at(2.7)).isCloseTo(cubic.applyAsDouble(2.7), within(1e-12));
    TableCurve of3 = curve(x -> x * x, Method.CUBIC, Extrapolation.HOLD, 0, 1, 4);
    assertThat(of3.at(2.7)).isCloseTo(2.7 * 2.7, within(1e-13));
  }

  @Test
  void akimaIsExactForParabolasOfEqualSteps() {
    TableCurve curve = curve(x -> x * x, Method.AKIMA, Extrapolation.HOLD, 0, 1, 2, 3, 4, 5);
    for (double x = 0; x < 5; x += 0.01) {
      assertThat(curve.at(x)).isCloseTo(x * x, within(1e-13));
    }
  }

  @Test
  void akimaDoesNotOvershootBesideAStep() {
    TableCurve curve =
        curve(x -> x < 3 ? 0 : 1, Method.AKIMA, Extrapolation.HOLD, 0, 1, 2, 3, 4, 5);
    for (double x = 0; x < 5; x += 0.01) {
      assertThat(curve.at(x)).isBetween(0.0, 1.0);
    }
  }

  /** Between two points it stays between their values, however different the intervals are. */
  @Test
  void monotoneStaysBetweenItsPoints() {
    Random random = new Random(5);
    for (int trial = 0; trial < 200; trial++) {
      double[] x = new double[8];
      double[] y = new double[8];
      for (int i = 0; i < x.length; i++) {
        x[i] = (i == 0 ? 0 : x[i - 1]) + Math.pow(10, 4 * random.nextDouble() - 3);
        y[i] = random.nextInt(3) == 0 && i > 0 ? y[i - 1] : random.nextGaussian();
      }
      TableCurve curve =
          new Table("f", list(x), list(y), Method.MONOTONE, Extrapolation.HOLD).curve();
      for (int i = 1; i < x.length; i++) {
        double low = Math.min(y[i - 1], y[i]) - 1e-14;
        double high = Math.max(y[i - 1], y[i]) + 1e-14;
        for (double part = 0; part <= 1; part += 0.02) {
          assertThat(curve.at(x[i - 1] + part * (x[i] - x[i - 1]))).isBetween(low, high);
        }
      }
    }
  }

  /** Where no slope is bounded, the slopes are those of parabolas. */
  @Test
  void monotoneIsExactForRisingParabolas() {
    TableCurve curve = curve(x -> x * x, Method.MONOTONE, Extrapolation.HOLD, 1, 2, 3, 4, 5);
    for (double x = 1; x < 5; x += 0.01) {
      assertThat(curve.at(x)).isCloseTo(x * x, within(1e-13));
    }
  }

  private static List<Double> list(double[] numbers) {
    return DoubleStream.of(numbers).boxed().toList();
  }

  @ParameterizedTest
  @EnumSource(Method.class)
  void curvePassesThroughThePointsAndHasItsDerivatives(Method method) {
    Table table = table(Math::sin, method, Extrapolation.LINEAR, X);
    TableCurve curve = table.curve();
    for (double x : X) {
      assertThat(curve.at(x)).isCloseTo(Math.sin(x), within(1e-15));
    }
    TableSlopes d = new TableSlopes(table);
    for (double x = -2; x < 4; x += 0.0371) {
      d.evaluate(x, 0);
      double h = 1e-5;
      double first = (curve.at(x + h) - curve.at(x - h)) / (2 * h);
      assertThat(d.byA).isCloseTo(first, within(1e-8));
      double slope = d.byA;
      double bend = d.byAA;
      d.evaluate(x + h, 0);
      assertThat((d.byA - slope) / h).isCloseTo(bend, within(1e-3));
    }
  }

  @Test
  void extrapolationIsTheOneSaid() {
    DoubleUnaryOperator line = x -> 3 * x;
    assertThat(curve(line, Method.LINEAR, Extrapolation.HOLD, 0, 1).at(2)).isEqualTo(3);
    assertThat(curve(line, Method.LINEAR, Extrapolation.LINEAR, 0, 1).at(2)).isEqualTo(6);
    assertThat(curve(line, Method.LINEAR, Extrapolation.LINEAR, 0, 1).at(-2)).isEqualTo(-6);
    TableCurve bounded = curve(line, Method.LINEAR, Extrapolation.ERROR, 0, 1);
    assertThat(bounded.at(1)).isEqualTo(3);
    assertThat(bounded.at(1.0001)).isNaN();
    assertThat(bounded.at(-0.0001)).isNaN();
  }

  @Test
  void argumentsAscend() {
    assertThatThrownBy(() -> curve(x -> x, Method.LINEAR, Extrapolation.HOLD, 0, 1, 1))
        .hasMessageContaining("do not ascend");
  }
}
