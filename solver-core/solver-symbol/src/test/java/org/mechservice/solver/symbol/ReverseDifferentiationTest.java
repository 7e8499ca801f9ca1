package org.mechservice.solver.symbol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ReverseDifferentiationTest {
  private static final int INPUTS = 12;
  private static final int STEPS = 150;

  private final Program program = new Program();
  private final Expressions e = program.expressions();

  private List<Scalar> inputs(int count) {
    List<Scalar> inputs = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      inputs.add(e.input(i));
    }
    return inputs;
  }

  private static double[] randomVector(Random random, int length) {
    return random.doubles(length, -1, 1).toArray();
  }

  private Map<Scalar, Scalar> map(List<Scalar> nodes, double[] numbers) {
    Map<Scalar, Scalar> map = new HashMap<>();
    for (int i = 0; i < numbers.length; i++) {
      map.merge(nodes.get(i), e.constant(numbers[i]), Scalar::plus);
    }
    return map;
  }

  /** Asserts λᵀ(J d) = (Jᵀλ)ᵀ d for values of the inputs, at a point. */
  private void assertDotProducts(
      List<Scalar> inputs, List<Scalar> values, double[] point, Random random) {
    double[] direction = randomVector(random, inputs.size());
    double[] weights = randomVector(random, values.size());
    Differentiation forward = new Differentiation(e, map(inputs, direction));
    ReverseDifferentiation reverse = new ReverseDifferentiation(e, map(values, weights));
    program.section("both sides of the identity", "s");
    for (int i = 0; i < values.size(); i++) {
      program.output(i, forward.of(values.get(i)));
    }
    for (int i = 0; i < inputs.size(); i++) {
      program.output(values.size() + i, reverse.by(inputs.get(i)));
    }
    double[] results = new double[values.size() + inputs.size()];
    program.evaluate(point, results);
    double left = 0;
    double right = 0;
    double size = 0;
    for (int i = 0; i < values.size(); i++) {
      left += weights[i] * results[i];
      size += Math.abs(weights[i] * results[i]);
    }
    for (int i = 0; i < inputs.size(); i++) {
      right += direction[i] * results[values.size() + i];
      size += Math.abs(direction[i] * results[values.size() + i]);
    }
    assertThat(right).isCloseTo(left, within(1e-12 * size));
  }

  @ParameterizedTest
  @EnumSource(
      mode = EnumSource.Mode.EXCLUDE,
      names = {"PLACE", "GIVEN"})
  void gradientsOfFunctionsAgreeWithTheirDirectionalDerivatives(MathFunction function) {
    Scalar x = e.input(0);
    Scalar y = e.input(1);
    Scalar[] arguments = {x, y, x.times(y), y.squared(), x.plus(y)};
    Scalar value = e.function(function, Arrays.copyOf(arguments, function.arity()));
    double[] point = {0.3, 0.7};
    assertDotProducts(List.of(x, y), List.of(value), point, new Random(1));
    assertDotProducts(List.of(x, y), List.of(value.markedSteep()), point, new Random(2));
  }

  /** A value of moderate size, whose slopes are moderate too. */
  private Scalar step(Random random, List<Scalar> values) {
    Scalar a = values.get(random.nextInt(values.size()));
    Scalar b = values.get(random.nextInt(values.size()));
    return switch (random.nextInt(9)) {
      case 0 -> a.plus(b).times(0.5);
      case 1 -> a.minus(b).times(0.5);
      case 2 -> a.times(b);
      case 3 -> a.over(b.squared().plus(e.constant(2)));
      case 4 -> a.squared().plus(e.one()).squareRoot().times(0.5);
      case 5 -> e.sine(a).times(e.cosine(b));
      case 6 -> e.function(MathFunction.TANH, a);
      case 7 -> e.function(MathFunction.MAX, a, b).negated();
      default -> e.function(MathFunction.CHOOSE, a, b, a.squared(), b);
    };
  }

  private List<Scalar> randomValues(Random random, List<Scalar> inputs) {
    List<Scalar> values = new ArrayList<>(inputs);
    for (int i = 0; i < STEPS; i++) {
      values.add(step(random, values));
    }
    return values.subList(INPUTS, values.size());
  }

  @Test
  void dotProductsAgreeForRandomPrograms() {
    for (int seed = 0; seed < 200; seed++) {
      ReverseDifferentiationTest fresh = new ReverseDifferentiationTest();
      Random random = new Random(seed);
      List<Scalar> inputs = fresh.inputs(INPUTS);
      List<Scalar> values = fresh.randomValues(random, inputs);
      fresh.assertDotProducts(inputs, values, randomVector(random, INPUTS), random);
    }
  }

  /** Σ (xᵢ − xᵢ₊₁)² sin xᵢ: 5 operations a term, whose gradient takes a few times as many. */
  @Test
  void costOfGradientDoesNotGrowWithTheNumberOfInputs() {
    for (int count : new int[] {10, 100, 1000}) {
      Program values = new Program();
      Expressions graph = values.expressions();
      Scalar sum = graph.zero();
      for (int i = 0; i < count; i++) {
        Scalar x = graph.input(i);
        sum = sum.plus(x.minus(graph.input(i + 1)).squared().times(graph.sine(x)));
      }
      values.section("sum", "s");
      values.output(0, sum);
      int plain = values.operationCount();
      ReverseDifferentiation reverse = new ReverseDifferentiation(graph, Map.of(sum, graph.one()));
      for (int i = 0; i <= count; i++) {
        values.output(1 + i, reverse.by(graph.input(i)));
      }
      assertThat(values.operationCount()).isLessThan(4 * plain);
    }
  }

  /** Slopes of √, 1/x and log x are infinite or NaN there, and nothing of this may come through. */
  @Test
  void whatIsNotChosenAddsNothing() {
    Scalar x = e.input(0);
    Scalar below = e.function(MathFunction.MAX, e.zero(), x);
    List<Scalar> level =
        List.of(
            below.squareRoot().markedSteep(),
            e.function(MathFunction.POWER, below, e.constant(0.3)).markedSteep(),
            e.function(MathFunction.CHOOSE, x, e.zero(), e.one(), x.squareRoot()),
            e.function(MathFunction.CHOOSE, x, e.zero(), e.one(), e.one().over(below)),
            e.function(MathFunction.MIN, e.zero(), e.function(MathFunction.LOG, below).negated()));
    program.section("slopes", "s");
    for (int i = 0; i < level.size(); i++) {
      program.output(i, new ReverseDifferentiation(e, Map.of(level.get(i), e.one())).by(x));
    }
    double[] slopes = new double[level.size()];
    program.evaluate(new double[] {-2}, slopes);
    assertThat(slopes).usingComparatorWithPrecision(0.0).containsOnly(0);
  }
}
