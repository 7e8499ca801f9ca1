package org.mechservice.solver.expression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.expression.Table.Extrapolation;
import org.mechservice.solver.expression.Table.Method;

/** Surfaces of maps: laws of their methods, continuity, and derivatives. */
class MapSurfaceTest {
  private static final List<Double> X = List.of(-1.0, 0.3, 0.5, 1.7, 2.0, 3.1);
  private static final List<Double> Y = List.of(10.0, 12.0, 13.5, 14.0, 17.0);

  private static TableMap map(
      List<Double> x, List<Double> y, DoubleBinaryOperator z, Method method, Extrapolation out) {
    List<Double> values = new ArrayList<>();
    for (double a : x) {
      for (double b : y) {
        values.add(z.applyAsDouble(a, b));
      }
    }
    return new TableMap("f", x, y, values, method, out);
  }

  private double at(MapSurface surface, double x, double y) {
    return surface.at(x, y);
  }

  @Test
  void splineIsExactForProductsOfCubics() {
    DoubleBinaryOperator z =
        (x, y) -> (1 - 2 * x + 0.5 * x * x + 3 * x * x * x) * (y * y - 0.1 * y * y * y);
    MapSurface surface = map(X, Y, z, Method.CUBIC, Extrapolation.HOLD).surface();
    for (double x = -1; x < 3.1; x += 0.1) {
      for (double y = 10; y < 17; y += 0.3) {
        // values reach 3e4; rounding of coefficients of that size
        assertThat(at(surface, x, y)).isCloseTo(z.applyAsDouble(x, y), within(1e-9));
      }
    }
  }

  @Test
  void akimaIsExactForProductsOfParabolasOfEqualSteps() {
    List<Double> steps = List.of(0.0, 1.0, 2.0, 3.0, 4.0, 5.0);
    DoubleBinaryOperator z = (x, y) -> (x * x - x) * (2 - y * y);
    MapSurface surface = map(steps, steps, z, Method.AKIMA, Extrapolation.HOLD).surface();
    for (double x = 0; x < 5; x += 0.13) {
      for (double y = 0; y < 5; y += 0.17) {
        assertThat(at(surface, x, y)).isCloseTo(z.applyAsDouble(x, y), within(1e-11));
      }
    }
  }

  @Test
  void linearIsBilinearInEachCell() {
    Random random = new Random(3);
    MapSurface surface =
        map(X, Y, (x, y) -> random.nextGaussian(), Method.LINEAR, Extrapolation.ERROR).surface();
    double u = 0.3;
    double v = 0.8;
    double x = 0.5 + u * 1.2;
    double y = 12 + v * 1.5;
    double low = (1 - v) * at(surface, 0.5, 12) + v * at(surface, 0.5, 13.5);
    double high = (1 - v) * at(surface, 1.7, 12) + v * at(surface, 1.7, 13.5);
    assertThat(at(surface, x, y)).isCloseTo((1 - u) * low + u * high, within(1e-14));
  }

  /** On a map whose values follow one argument only, the surface is the curve of the table. */
  @ParameterizedTest
  @EnumSource(Method.class)
  void mapOfOneArgumentIsTheTable(Method method) {
    for (Extrapolation outside : List.of(Extrapolation.HOLD, Extrapolation.LINEAR)) {
      Random random = new Random(5);
      List<Double> values = X.stream().map(x -> random.nextGaussian()).toList();
      TableCurve curve = new Table("c", X, values, method, outside).curve();
      MapSurface alongX = map(X, Y, (x, y) -> values.get(X.indexOf(x)), method, outside).surface();
      MapSurface alongY = map(Y, X, (y, x) -> values.get(X.indexOf(x)), method, outside).surface();
      for (double x = -2; x < 4; x += 0.093) {
        assertThat(at(alongX, x, 9 + x * x)).isCloseTo(curve.at(x), within(1e-13));
        assertThat(at(alongY, 9 + x * x, x)).isCloseTo(curve.at(x), within(1e-13));
      }
    }
  }

  @ParameterizedTest
  @EnumSource(Method.class)
  void surfacePassesThroughThePointsAndHasItsDerivatives(Method method) {
    DoubleBinaryOperator z = (x, y) -> Math.sin(x) * Math.cos(0.4 * y) + 0.1 * x * y;
    TableMap map = map(X, Y, z, method, Extrapolation.LINEAR);
    MapSurface surface = map.surface();
    TableSlopes scratch = new TableSlopes(map);
    TableSlopes d = new TableSlopes(map);
    for (double x : X) {
      for (double y : Y) {
        assertThat(at(surface, x, y)).isCloseTo(z.applyAsDouble(x, y), within(1e-14));
      }
    }
    double h = 1e-5;
    for (double x = -2; x < 4; x += 0.371) {
      for (double y = 9; y < 18; y += 0.473) {
        double byX = (at(surface, x + h, y) - at(surface, x - h, y)) / (2 * h);
        double byY = (at(surface, x, y + h) - at(surface, x, y - h)) / (2 * h);
        d.evaluate(x, y);
        assertThat(d.byA).isCloseTo(byX, within(1e-8));
        assertThat(d.byB).isCloseTo(byY, within(1e-8));
        scratch.evaluate(x + h, y);
        // one-sided differences of slopes: h times the third derivative
        assertThat((scratch.byA - d.byA) / h).isCloseTo(d.byAA, within(2e-3));
        assertThat((scratch.byB - d.byB) / h).isCloseTo(d.byAB, within(2e-3));
        scratch.evaluate(x, y + h);
        assertThat((scratch.byB - d.byB) / h).isCloseTo(d.byBB, within(2e-3));
      }
    }
  }

  /** Values and both slopes from the two sides of every line of the grid, corners included. */
  @ParameterizedTest
  @CsvSource({"AKIMA, HOLD", "AKIMA, LINEAR", "CUBIC, HOLD", "CUBIC, LINEAR"})
  void slopesAreContinuousAcrossTheGrid(Method method, Extrapolation outside) {
    Random random = new Random(11);
    TableMap map = map(X, Y, (x, y) -> random.nextGaussian(), method, outside);
    MapSurface surface = map.surface();
    TableSlopes scratch = new TableSlopes(map);
    double tiny = 1e-9;
    for (double x : X) {
      for (double y = 9; y < 18; y += 0.31) {
        boolean edge = x == X.get(0) || x == X.get(X.size() - 1);
        // slopes of these values on cells of 0.2 reach 200, and curvatures 1e4
        assertThat(at(surface, x - tiny, y)).isCloseTo(at(surface, x, y), within(1e-6));
        scratch.evaluate(x - tiny, y);
        double byX = scratch.byA;
        double byY = scratch.byB;
        scratch.evaluate(x + tiny, y);
        // a held value has a corner at the edge of the grid, and nowhere else
        if (!edge || outside == Extrapolation.LINEAR) {
          assertThat(scratch.byA).isCloseTo(byX, within(1e-4));
        }
        assertThat(scratch.byB).isCloseTo(byY, within(1e-4));
      }
    }
  }

  @ParameterizedTest
  @EnumSource(Method.class)
  void smoothFunctionsAreApproachedInTheOrderOfTheMethod(Method method) {
    double coarse = error(method, 17);
    double fine = error(method, 33);
    // monotone: the slope at the point next to an extremum is 0, off by the distance to it
    double order =
        switch (method) {
          case LINEAR, MONOTONE -> 1.9; // second order
          case AKIMA -> 2.4; // at least third
          case CUBIC -> 3.7; // fourth
        };
    assertThat(Math.log(coarse / fine) / Math.log(2)).isGreaterThan(order);
  }

  private double error(Method method, int points) {
    List<Double> grid = new ArrayList<>();
    for (int i = 0; i < points; i++) {
      grid.add(3.0 * i / (points - 1));
    }
    DoubleBinaryOperator z = (x, y) -> Math.sin(2 * x + 1) * Math.exp(-0.5 * y) + x * Math.cos(y);
    MapSurface surface = map(grid, grid, z, method, Extrapolation.ERROR).surface();
    double worst = 0;
    for (double x = 0.4; x < 2.6; x += 0.0317) {
      for (double y = 0.4; y < 2.6; y += 0.0291) {
        worst = Math.max(worst, Math.abs(at(surface, x, y) - z.applyAsDouble(x, y)));
      }
    }
    return worst;
  }

  @Test
  void extrapolationIsTheOneSaid() {
    List<Double> two = List.of(0.0, 1.0);
    DoubleBinaryOperator z = (x, y) -> 3 * x + 5 * y + 7 * x * y;
    for (Method method : Method.values()) {
      MapSurface held = map(two, two, z, method, Extrapolation.HOLD).surface();
      assertThat(at(held, 2, 0.5)).isCloseTo(z.applyAsDouble(1, 0.5), within(1e-14));
      assertThat(at(held, -3, 9)).isCloseTo(z.applyAsDouble(0, 1), within(1e-14));
      MapSurface on = map(two, two, z, method, Extrapolation.LINEAR).surface();
      assertThat(at(on, 2, -4)).isCloseTo(z.applyAsDouble(2, -4), within(1e-12));
      MapSurface none = map(two, two, z, method, Extrapolation.ERROR).surface();
      assertThat(at(none, 0.5, 1.1)).isNaN();
      assertThat(at(none, -0.1, 0.5)).isNaN();
      assertThat(at(none, 1, 1)).isEqualTo(15);
    }
    assertThat(at(map(X, Y, z, Method.LINEAR, Extrapolation.HOLD).surface(), Double.NaN, 12))
        .isNaN();
  }

  @Test
  void whatIsNoGridIsRefused() {
    assertThatThrownBy(() -> new TableMap("f", X, Y, X, Method.LINEAR, Extrapolation.HOLD))
        .hasMessageContaining("6 values on 6 x 5");
    assertThatThrownBy(
            () -> map(List.of(1.0, 1.0), Y, (x, y) -> 0, Method.LINEAR, Extrapolation.HOLD))
        .hasMessageContaining("do not ascend");
  }
}
