package org.mechservice.solver.mechanism;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.StateValue;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.TableValue;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.expression.Table;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/** Places in time at which formulas change their form, beside the zeros of their arguments. */
final class TimePlacesTest {
  private static final Expression T = new Time();

  private static Expression call(MathFunction function, Expression... arguments) {
    return Expression.call(function, List.of(arguments));
  }

  private static Expression minus(Expression a, double b) {
    return new Sum(a, Expression.of(-b));
  }

  private static List<Double> places(Expression formula, double from, double to) {
    Mechanism empty =
        new Mechanism(
            "m",
            new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
            Vector3.ZERO,
            List.of(),
            List.of());
    Mechanism mechanism =
        empty.withFurtherStates(List.of(new FurtherState("s", 0, formula, "1", 0, Origin.NONE)));
    return mechanism.timeJumps(from, to);
  }

  @Test
  void zerosOfASineAreAllFound() {
    List<Double> found = places(call(MathFunction.SIGNUM, call(MathFunction.SIN, T)), 0.1, 100);
    assertThat(found).hasSize(31);
    for (int k = 1; k <= 31; k++) {
      assertThat(found.get(k - 1)).isCloseTo(k * Math.PI, within(4 * Math.ulp(k * Math.PI)));
    }
  }

  @Test
  void bothEndsOfARampOfTSquaredAreFound() {
    Expression argument = new Product(minus(new Product(T, T), 49), Expression.of(10));
    assertThat(places(call(MathFunction.SMOOTH_STEP, argument), 0, 10))
        .satisfiesExactly(
            t -> assertThat(t).isCloseTo(7, within(1e-14)),
            t -> assertThat(t).isCloseTo(Math.sqrt(49.1), within(1e-14)));
  }

  @Test
  void knotsOfATableOfTSquaredAreFound() {
    Table table =
        new Table(
            "tb",
            List.of(0.0, 7.0, 7.01, 20.0),
            List.of(0.0, 0.0, 1.0, 0.0),
            Table.Method.AKIMA,
            Table.Extrapolation.HOLD);
    List<Double> found = places(new TableValue(table, List.of(new Product(T, T))), 0.5, 10);
    assertThat(found).hasSize(3);
    assertThat(found.get(0)).isCloseTo(Math.sqrt(7), within(1e-14));
    assertThat(found.get(1)).isCloseTo(Math.sqrt(7.01), within(1e-14));
    assertThat(found.get(2)).isCloseTo(Math.sqrt(20), within(1e-14));
  }

  @Test
  void smallerOfTwoCurvesChangesWhereTheyMeet() {
    // t² = t + 2 at 2
    Expression formula = call(MathFunction.MIN, new Product(T, T), minus(T, -2));
    assertThat(places(formula, 0, 10))
        .singleElement()
        .satisfies(t -> assertThat(t).isCloseTo(2, within(1e-14)));
  }

  /** Pulses p(t) > 0 between two zeros of a parabola in t, at any place and of any width. */
  @Test
  void noPulseIsTooShort() {
    Random random = new Random(42);
    for (int i = 0; i < 300; i++) {
      double middle = 10 * random.nextDouble();
      double width = Math.pow(10, -1 - 7 * random.nextDouble());
      Expression way = minus(T, middle);
      Expression parabola = new Negation(minus(new Product(way, way), width * width));
      List<Double> found = places(call(MathFunction.STEP, parabola), -1, 12);
      // rounding of (t - m)² - w² moves a zero by ulp(w²)/(2 w), which is below ulp(t)
      assertThat(found).as("middle %s, width %s", middle, width).hasSize(2);
      assertThat(found.get(0)).isCloseTo(middle - width, within(1e-14));
      assertThat(found.get(1)).isCloseTo(middle + width, within(1e-14));
    }
  }

  @Test
  void argumentThatRestsAtZeroIsNoPlace() {
    Expression rests = call(MathFunction.MAX, Expression.ZERO, minus(new Product(T, T), 4));
    List<Double> found = new ArrayList<>(places(call(MathFunction.SIGNUM, rests), 0, 10));
    assertThat(found).isNotEmpty().allSatisfy(t -> assertThat(t).isCloseTo(2, within(1e-14)));
  }

  @Test
  void choicesOfTheStateHaveNone() {
    assertThat(places(call(MathFunction.STEP, new Sum(T, new StateValue(0))), 0, 10)).isEmpty();
  }
}
