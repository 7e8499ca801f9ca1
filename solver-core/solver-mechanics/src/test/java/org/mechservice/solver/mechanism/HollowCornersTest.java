package org.mechservice.solver.mechanism;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Argument;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.symbol.MathFunction;

class HollowCornersTest {
  private static final Expression S = new Argument();
  private static final Expression ONE = Expression.of(1);

  private static Expression call(MathFunction function, Expression... arguments) {
    return Expression.call(function, List.of(arguments));
  }

  @Test
  void maximaLiftTheCurveAndMinimaLowerIt() {
    Expression maximum = call(MathFunction.MAX, ONE, S);
    Expression minimum = call(MathFunction.MIN, ONE, S);
    Expression difference = new Sum(ONE, new Negation(S));
    assertThat(HollowCorners.of(maximum)).containsExactly(difference);
    assertThat(HollowCorners.of(minimum)).isEmpty();
    assertThat(HollowCorners.of(new Negation(maximum))).isEmpty();
    assertThat(HollowCorners.of(new Product(Expression.of(-2), minimum)))
        .containsExactly(difference);
    assertThat(HollowCorners.of(call(MathFunction.MAX, minimum, ONE))).hasSize(1);
  }

  @Test
  void absoluteValuesHaveTheirArgument() {
    Expression valley = call(MathFunction.ABS, S);
    assertThat(HollowCorners.of(valley)).containsExactly(S);
    assertThat(HollowCorners.of(new Negation(valley))).isEmpty();
  }

  /** The sign of s is not known, so the corner may be a hollow. */
  @Test
  void cornersOfUnknownSignCount() {
    assertThat(HollowCorners.of(new Product(S, call(MathFunction.MIN, ONE, S)))).hasSize(1);
    assertThat(HollowCorners.of(new Product(S, call(MathFunction.MAX, ONE, S)))).hasSize(1);
  }
}
