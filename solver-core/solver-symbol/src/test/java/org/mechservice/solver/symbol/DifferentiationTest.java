package org.mechservice.solver.symbol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class DifferentiationTest {
  private static final double H = 1e-5;

  /** Central differences leave h² and the rounding of two values over h. */
  private static final double TOLERANCE = 1e-8;

  private static final NumberRow ROW = new NumberRow(0.1, 0.5, 2);

  private final Program program = new Program();
  private final Expressions e = program.expressions();
  private final Scalar x = e.input(0);
  private final Scalar y = e.input(1);

  private void assertSlope(Scalar value, double atX, double atY) {
    Scalar slope = new Differentiation(e, Map.of(x, e.one(), y, e.constant(2))).of(value);
    program.section("value and slope", "s");
    program.output(0, value);
    program.output(1, slope);
    double[] ahead = new double[2];
    double[] behind = new double[2];
    double[] here = new double[2];
    program.evaluate(new double[] {atX + H, atY + 2 * H}, ahead);
    program.evaluate(new double[] {atX - H, atY - 2 * H}, behind);
    program.evaluate(new double[] {atX, atY}, here);
    double difference = (ahead[0] - behind[0]) / (2 * H);
    assertThat(here[1]).isCloseTo(difference, within(TOLERANCE * (1 + Math.abs(difference))));
  }

  @ParameterizedTest
  @EnumSource(
      mode = EnumSource.Mode.EXCLUDE,
      names = {"PICK", "HELD", "CLOSEST", "TOUCH", "PLACE", "GIVEN"})
  void slopesOfFunctionsAreTheirDifferences(MathFunction function) {
    Scalar[] arguments = {x, y, x.times(y), y.squared()};
    Scalar value =
        switch (function) {
          case INTERVAL -> e.interval(new NumberRow(-1, 0.2, 0.4, 3), x).times(x);
          case ELEMENT -> e.element(new NumberRow(4, 7, -2), e.interval(ROW, y)).times(y);
          default -> e.function(function, Arrays.copyOf(arguments, function.arity()));
        };
    assertSlope(value, 0.3, 0.7);
  }

  /** Guarded products are slower; e^y is steep, and alone along x. */
  @Test
  void whatIsSteepIsGuardedOnlyWhereItChanges() {
    Scalar steep = e.function(MathFunction.EXP, y).markedSteep();
    Scalar value = e.sine(steep.times(x)).times(x.squared());
    Scalar byX = new Differentiation(e, Map.of(x, e.one())).of(value);
    Scalar byY = new Differentiation(e, Map.of(y, x)).of(value);
    program.section("slopes", "s");
    program.output(0, byX);
    assertThat(calls(MathFunction.PRODUCT)).isZero();
    program.output(1, byY);
    assertThat(calls(MathFunction.PRODUCT)).isPositive();
  }

  private long calls(MathFunction function) {
    int[] uses = program.uses();
    return IntStream.range(0, uses.length)
        .filter(id -> uses[id] > 0)
        .mapToObj(e::node)
        .filter(node -> node.is(ScalarOperation.FUNCTION) && node.function() == function)
        .count();
  }

  /** What a search has found is held: the formula around it says how it changes. */
  @Test
  void foundNumbersHaveNoSlope() {
    Differentiation byX = new Differentiation(e, Map.of(x, e.one()));
    NumberRow line = new NumberRow(0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0);
    assertThat(byX.of(e.closest(line, x, y)).isZero()).isTrue();
    assertThat(byX.of(e.function(MathFunction.PICK, x, y, x, y)).isZero()).isTrue();
    assertThat(byX.of(e.function(MathFunction.HELD, x)).isZero()).isTrue();
    assertThat(byX.of(e.function(MathFunction.TOUCH, x, y, x, y, x)).isZero()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.4, 0.2, 1.3})
  void slopesOfRationalFormulasAreTheirDifferences(double at) {
    Scalar angle = x.times(2).minus(y);
    Scalar value =
        e.sine(angle)
            .times(e.cosine(x))
            .plus(x.over(y.squared().plus(e.one())))
            .minus(x.squared().plus(e.constant(3)).squareRoot().negated());
    assertSlope(value, at, 0.6);
  }

  @ParameterizedTest
  @EnumSource(names = {"TANH", "ATAN"})
  void slopesOfWhatLevelsOffDieAwayFarOut(MathFunction function) {
    Differentiation byX = new Differentiation(e, Map.of(x, e.one()));
    Scalar slope = byX.of(e.function(function, x));
    program.section("slope and its own slope", "s");
    program.output(0, slope);
    program.output(1, byX.of(slope));
    double[] slopes = new double[2];
    for (double far : new double[] {-1e200, -5e3, -500, 500, 5e3, 1e200}) {
      program.evaluate(new double[] {far, 0}, slopes);
      assertThat(slopes[0]).isBetween(0.0, 1e-5);
      assertThat(slopes[1]).isCloseTo(0, within(1e-5));
    }
  }

  /** √0 within what is constant there, or is not chosen there, would give 0 · ∞. */
  @Test
  void whatDoesNotChangeOrIsNotChosenAsksForNoSlope() {
    Scalar zero = e.zero();
    Scalar one = e.one();
    Scalar below = e.function(MathFunction.MAX, zero, x);
    Scalar above = e.function(MathFunction.MIN, one, x);
    List<Scalar> level =
        List.of(
            below.squareRoot().markedSteep(),
            e.function(MathFunction.POWER, below, e.constant(0.3)).markedSteep(),
            e.function(MathFunction.CHOOSE, x, zero, one, one.over(below)),
            e.function(MathFunction.ATAN2, below, below),
            e.function(MathFunction.ASIN, e.function(MathFunction.MAX, above, one)).markedSteep(),
            e.function(MathFunction.ACOS, e.function(MathFunction.MAX, above, one)).markedSteep(),
            x.minus(x.squared().squareRoot().negated()));
    Differentiation byX = new Differentiation(e, Map.of(x, one));
    program.section("slopes", "s");
    for (int i = 0; i < level.size(); i++) {
      program.output(i, byX.of(level.get(i)));
    }
    double[] slopes = new double[level.size()];
    program.evaluate(new double[] {-2, 0}, slopes);
    assertThat(slopes).usingComparatorWithPrecision(0.0).containsOnly(0);
  }
}
