package org.mechservice.mechml.resolve.force;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Argument;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.symbol.MathFunction;

/** Places where a height is not smooth, of formulas within formulas. */
class HeightPiecesTest {
  /** s − place. */
  private static Expression behind(double place) {
    return new Sum(new Argument(), Expression.of(-place));
  }

  private static Expression call(MathFunction function, Expression... arguments) {
    return Expression.call(function, List.of(arguments));
  }

  /** A triangle from 1 to 4 with its top at 2: max(0, min(s − 1, (4 − s)/2)). */
  private static Expression triangle() {
    Expression down = new Product(Expression.of(-0.5), behind(4));
    return call(MathFunction.MAX, Expression.ZERO, call(MathFunction.MIN, behind(1), down));
  }

  @Test
  void minimumWithinAMaximumHasThreeCorners() {
    assertThat(HeightPieces.of(triangle()).orElseThrow().breaks()).containsExactly(1, 2, 4);
  }

  /** | |s − 3| − 1 | is zero at 2 and 4 and has its top at 3; a triangle beside it adds its own. */
  @Test
  void sumsAndAbsoluteValuesHaveTheCornersOfBoth() {
    Expression folded =
        call(MathFunction.ABS, new Sum(call(MathFunction.ABS, behind(3)), Expression.of(-1)));
    assertThat(HeightPieces.of(folded).orElseThrow().breaks()).containsExactly(2, 3, 4);
    Expression both = new Sum(folded, new Negation(triangle()));
    assertThat(HeightPieces.of(both).orElseThrow().breaks()).containsExactly(1, 2, 3, 4);
  }

  /** The same corner from two formulas, whose places differ by a rounding, is one. */
  @Test
  void cornersThatRoundingPartsAreOne() {
    Expression one = call(MathFunction.MAX, Expression.ZERO, behind(0.1 + 0.2));
    Expression other = call(MathFunction.MAX, Expression.ZERO, behind(0.3));
    assertThat(HeightPieces.of(new Sum(one, other)).orElseThrow().breaks()).hasSize(1);
  }

  @Test
  void curvesWithinAMaximumAreSoughtOtherwise() {
    Expression parabola = new Product(behind(1), new Negation(behind(2)));
    assertThat(HeightPieces.of(call(MathFunction.MAX, Expression.ZERO, parabola))).isEmpty();
    Expression smooth = call(MathFunction.SMOOTH_STEP, behind(1));
    assertThat(HeightPieces.of(call(MathFunction.MAX, Expression.of(0.5), smooth))).isEmpty();
  }

  /** Each side of |s − 3| + 1 would be zero on the other one. */
  @Test
  void linesThatEndBeforeTheirZeroHaveNone() {
    Expression valley = new Sum(call(MathFunction.ABS, behind(3)), Expression.of(1));
    assertThat(
            HeightPieces.of(call(MathFunction.MAX, Expression.ZERO, valley)).orElseThrow().breaks())
        .containsExactly(3);
  }

  /** max(s, max(1, 2)): what is inside has no corner of its own. */
  @Test
  void constantWithinAMaximumHasNoCorner() {
    Expression two = call(MathFunction.MAX, Expression.of(1), Expression.of(2));
    assertThat(HeightPieces.of(call(MathFunction.MAX, new Argument(), two)).orElseThrow().breaks())
        .containsExactly(2);
  }
}
