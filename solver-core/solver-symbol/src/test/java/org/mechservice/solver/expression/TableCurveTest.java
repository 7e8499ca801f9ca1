package org.mechservice.solver.expression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
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
