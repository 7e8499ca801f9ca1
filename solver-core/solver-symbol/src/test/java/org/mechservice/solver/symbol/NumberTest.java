package org.mechservice.solver.symbol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import org.junit.jupiter.api.Test;

/** Numbers that simplifications do not look at. */
class NumberTest {
  private final Program program = new Program();
  private final Expressions e = program.expressions();
  private final Scalar x = e.input(0);

  private double value(Scalar of, double at) {
    program.section("", "s");
    program.output(0, of);
    double[] out = new double[1];
    assertThat(program.evaluate(new double[] {at}, out)).isEqualTo(-1);
    return out[0];
  }

  @Test
  void zeroAndOneStayOperands() {
    assertThat(x.times(e.zero()).isZero()).isTrue();
    Scalar product = x.times(e.number(0)).plus(x.times(e.number(1)));
    assertThat(product.isConstant()).isFalse();
    assertThat(value(product, 0.1)).isEqualTo(0.1);
  }

  @Test
  void equalNumbersAreNodesOfTheirOwn() {
    assertThat(e.number(2)).isNotSameAs(e.number(2)).isNotSameAs(e.constant(2));
    assertThat(e.numbers()).containsExactly(2.0, 2.0);
  }

  @Test
  void aNumberDoesNotChange() {
    Scalar two = e.number(2);
    Differentiation along = new Differentiation(e, Map.of(x, e.one()));
    assertThat(along.of(two).isZero()).isTrue();
    assertThat(along.of(two.times(x))).isSameAs(two);
    ReverseDifferentiation by = new ReverseDifferentiation(e, Map.of(two.times(x), e.one()));
    assertThat(by.by(two).isZero()).isTrue();
    assertThat(by.by(x)).isSameAs(two);
  }

  @Test
  void aCopyInAnotherGraphIsANumberOfTheSameIndex() {
    e.number(5);
    Scalar seven = e.number(7);
    Expressions other = new Expressions();
    Scalar copy = other.alike(seven, seven.operands());
    assertThat(copy.isNumber()).isTrue();
    assertThat(copy.isConstant()).isFalse();
    assertThat(copy.index()).isEqualTo(1);
    assertThat(other.alike(seven, seven.operands())).isSameAs(copy);
  }

  @Test
  void whatIsNotFiniteIsRefused() {
    assertThatThrownBy(() -> e.number(Double.NaN)).isInstanceOf(ArithmeticException.class);
  }
}
