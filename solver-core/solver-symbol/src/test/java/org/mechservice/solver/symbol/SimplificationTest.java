package org.mechservice.solver.symbol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

class SimplificationTest {
  private final Expressions expressions = new Expressions();
  private final Scalar zero = expressions.zero();
  private final Scalar one = expressions.one();
  private final Scalar x = expressions.input(0);
  private final Scalar y = expressions.input(1);

  @Test
  void constantsAreFolded() {
    Scalar two = one.plus(one);
    assertThat(two).isSameAs(expressions.constant(2));
    assertThat(two.times(two).minus(one).over(two)).isSameAs(expressions.constant(1.5));
    assertThat(expressions.constant(9).squareRoot()).isSameAs(expressions.constant(3));
  }

  @Test
  void constantsOfDifferentOperationsStayApart() {
    Scalar two = expressions.constant(2);
    Scalar three = expressions.constant(3);
    assertThat(two.plus(x.plus(one)).operands()).containsExactly(two, x.plus(one));
    assertThat(two.plus(one.minus(x)).operands()).containsExactly(two, one.minus(x));
    assertThat(two.minus(x.plus(one)).operands()).containsExactly(two, x.plus(one));
    assertThat(two.minus(one.minus(x)).operands()).containsExactly(two, one.minus(x));
    assertThat(x.times(3).times(2).operands()).containsExactly(two, x.times(three));
  }

  /** A part that is a number when code is written is one of two parts when it is read in a run. */
  @Test
  void partsOfASumStayInIt() {
    Scalar two = expressions.constant(2);
    assertThat(x.plus(two).minus(two).operands())
        .containsExactly(expressions.constant(-2), x.plus(two));
    assertThat(x.minus(y).plus(y).operands()).contains(x.minus(y), y);
    assertThat(x.plus(y).minus(x).operands()).containsExactly(x.plus(y), x);
    assertThat(x.minus(x.minus(y)).operands()).containsExactly(x, x.minus(y));
  }

  @Test
  void zeroAndOneDisappear() {
    assertThat(x.plus(zero)).isSameAs(x);
    assertThat(zero.minus(x)).isSameAs(x.negated());
    assertThat(x.times(zero)).isSameAs(zero);
    assertThat(x.times(one)).isSameAs(x);
    assertThat(zero.over(x)).isSameAs(zero);
    assertThat(x.over(one)).isSameAs(x);
  }

  @Test
  void equalTermsCancel() {
    assertThat(x.minus(x)).isSameAs(zero);
    assertThat(x.over(x)).isSameAs(one);
  }

  @Test
  void signsMoveOutwardsUntilASumTakesThemUp() {
    assertThat(x.negated().times(y)).isSameAs(x.times(y).negated());
    assertThat(x.negated().times(y.negated())).isSameAs(x.times(y));
    assertThat(x.plus(y.negated())).isSameAs(x.minus(y));
    assertThat(x.minus(y.times(-3))).isSameAs(x.plus(y.times(3)));
    assertThat(x.negated().over(y)).isSameAs(x.over(y).negated());
    assertThat(x.negated().negated()).isSameAs(x);
    assertThat(expressions.sine(x.negated())).isSameAs(expressions.sine(x).negated());
    assertThat(expressions.cosine(x.negated())).isSameAs(expressions.cosine(x));
  }

  @Test
  void equalExpressionsAreOneNode() {
    assertThat(x.plus(y)).isSameAs(y.plus(x));
    assertThat(x.times(y)).isSameAs(y.times(x));
    Scalar difference = x.minus(y);
    assertThat(y.minus(x)).isSameAs(difference.negated());
  }

  @Test
  void whatHasNoFiniteValueIsLeftToTheRunToFind() {
    Scalar huge = expressions.constant(1e308);
    assertThat(x.over(zero).operation()).isEqualTo(ScalarOperation.DIVIDE);
    assertThat(one.over(zero).operation()).isEqualTo(ScalarOperation.DIVIDE);
    assertThat(huge.plus(huge).operation()).isEqualTo(ScalarOperation.ADD);
    assertThat(huge.negated().minus(huge).operation()).isEqualTo(ScalarOperation.SUBTRACT);
    assertThat(huge.times(huge).operation()).isEqualTo(ScalarOperation.MULTIPLY);
    assertThat(huge.times(x.times(1e308)).operation()).isEqualTo(ScalarOperation.MULTIPLY);
    assertThat(one.negated().squareRoot().operation()).isEqualTo(ScalarOperation.SQUARE_ROOT);
    assertThatThrownBy(() -> expressions.constant(Double.NaN))
        .isInstanceOf(ArithmeticException.class);
  }

  @Test
  void simplifiedExpressionsKeepTheirValues() {
    for (long seed = 0; seed < 200; seed++) {
      RandomExpression expression = new RandomExpression(seed);
      // Quotients by constants change rounding only; values stay below 10.
      assertThat(expression.simplified())
          .as("seed %s", seed)
          .isCloseTo(expression.plain(), within(1e-12));
    }
  }

  /** The same random operations on scalars and on numbers. */
  private static final class RandomExpression {
    private final Program program = new Program();
    private final Scalar[] nodes = new Scalar[40];
    private final double[] values = new double[40];
    private final double[] inputs;

    RandomExpression(long seed) {
      Random random = new Random(seed);
      inputs = new double[] {random.nextDouble() + 1, random.nextDouble() + 2};
      set(0, program.expressions().input(0), inputs[0]);
      set(1, program.expressions().input(1), inputs[1]);
      set(2, program.expressions().constant(3), 3);
      for (int i = 3; i < nodes.length; i++) {
        step(i, random.nextInt(4), random.nextInt(i), random.nextInt(i));
      }
      program.section("all", "s");
      program.output(0, nodes[nodes.length - 1]);
    }

    private void set(int i, Scalar node, double value) {
      nodes[i] = node;
      values[i] = value;
    }

    private void step(int i, int kind, int a, int b) {
      switch (kind) {
        case 0 -> set(i, nodes[a].plus(nodes[b]).times(0.25), (values[a] + values[b]) * 0.25);
        case 1 -> set(i, nodes[a].minus(nodes[b]), values[a] - values[b]);
        case 2 -> set(i, nodes[a].times(nodes[b]).times(0.25), values[a] * values[b] * 0.25);
        default -> set(i, nodes[a].negated(), -values[a]);
      }
    }

    double plain() {
      return values[values.length - 1];
    }

    double simplified() {
      double[] out = new double[1];
      program.evaluate(inputs, out);
      return out[0];
    }
  }
}
