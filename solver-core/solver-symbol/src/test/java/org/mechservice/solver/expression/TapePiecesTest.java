package org.mechservice.solver.expression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.StateValue;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.symbol.MathFunction;

/** Which choices of formulas are open over a box of their leaves, and which of them matter. */
final class TapePiecesTest {
  private static final Expression X = new StateValue(0);
  private static final Expression Y = new StateValue(1);

  private static Expression call(MathFunction function, Expression... arguments) {
    return Expression.call(function, List.of(arguments));
  }

  private static Expression positive(Expression x) {
    return call(MathFunction.MAX, Expression.ZERO, x);
  }

  /** Returns the number of open choices for x and y in intervals. */
  private static int open(
      Expression formula, double xLow, double xHigh, double yLow, double yHigh) {
    return decided(formula, xLow, xHigh, yLow, yHigh).undecidedCount();
  }

  private static TapePieces decided(
      Expression formula, double xLow, double xHigh, double yLow, double yHigh) {
    Tape tape = new Tape(List.of(formula));
    TapePieces pieces = new TapePieces(tape, 1);
    for (int leaf = 0; leaf < tape.leaves().size(); leaf++) {
      boolean x = tape.leaves().get(leaf).equals(X);
      pieces.setLeaf(leaf, x ? xLow : yLow, x ? xHigh : yHigh);
    }
    pieces.decide();
    return pieces;
  }

  @Test
  void choiceIsOpenWhereItsBoundaryLiesInTheBox() {
    for (MathFunction function :
        List.of(MathFunction.STEP, MathFunction.SIGNUM, MathFunction.ABS)) {
      assertThat(open(call(function, X), -1, 1, 0, 0)).as(function.symbol()).isOne();
      assertThat(open(call(function, X), 0.1, 1, 0, 0)).as(function.symbol()).isZero();
      assertThat(open(call(function, X), -1, -0.1, 0, 0)).as(function.symbol()).isZero();
    }
    assertThat(open(call(MathFunction.FLOOR, X), 1.1, 1.9, 0, 0)).isZero();
    assertThat(open(call(MathFunction.FLOOR, X), 1.9, 2.1, 0, 0)).isOne();
    assertThat(open(call(MathFunction.SMOOTH_STEP, X), -1, -0.1, 0, 0)).isZero();
    assertThat(open(call(MathFunction.SMOOTH_STEP, X), 0.1, 0.9, 0, 0)).isZero();
    assertThat(open(call(MathFunction.SMOOTH_STEP, X), 0.9, 1.1, 0, 0)).isOne();
    assertThat(open(call(MathFunction.MIN, X, Y), 0, 1, 2, 3)).isZero();
    assertThat(open(call(MathFunction.MIN, X, Y), 0, 2.5, 2, 3)).isOne();
  }

  @Test
  void factorOfZeroDoesNotMatter() {
    Expression touching = positive(Y);
    Expression gated = new Product(touching, call(MathFunction.ABS, X));
    assertThat(open(gated, -1, 1, -2, -1)).isZero();
    assertThat(open(gated, -1, 1, 1, 2)).isOne();
    assertThat(open(gated, -1, 1, -1, 2)).isEqualTo(2);
  }

  @Test
  void argumentThatIsNotTakenDoesNotMatter() {
    Expression outer = call(MathFunction.MAX, call(MathFunction.ABS, X), Y);
    assertThat(open(outer, -1, 1, 5, 6)).isZero();
    assertThat(open(outer, -1, 1, -6, -5)).isOne();
  }

  @Test
  void wholeArgumentOfAStepThatKeepsItsValueDoesNotMatter() {
    Expression inner = new Sum(call(MathFunction.ABS, X), Expression.of(1));
    assertThat(open(call(MathFunction.STEP, inner), -1, 1, 0, 0)).isZero();
  }

  @Test
  void formulaThatIsZeroOnBothSidesIsWatchedWhereItCanLeaveZero() {
    // as in the law of a contact: the outer choice compares 0 with 0 while the bodies are apart
    Expression law = positive(new Product(positive(X), new Sum(Expression.of(1), Y)));
    assertThat(open(law, -2, -1, -3, 3)).isZero();
    assertThat(open(law, -2, 1, 0, 3)).isGreaterThan(0);
  }

  /** A value of a thousand beside a boundary of size one would make far ways count as touches. */
  @Test
  void sizeOfAChoiceIsThatOfWhatDecidesIt() {
    for (MathFunction part : List.of(MathFunction.WHERE, MathFunction.ELSEWHERE)) {
      assertThat(sizeBetween(call(part, X, Y), -2, 1, 500, 1000)).as(part.name()).isEqualTo(2);
    }
    assertThat(sizeBetween(call(MathFunction.MAX, X, Y), -2, 1, 500, 1000)).isEqualTo(1000);
    assertThat(sizeBetween(call(MathFunction.SIGNUM, X), -2, 1, 0, 0)).isEqualTo(2);
  }

  private static double sizeBetween(
      Expression formula, double xLow, double xHigh, double yLow, double yHigh) {
    return decided(formula, xLow, xHigh, yLow, yHigh).size(0);
  }

  @Test
  void choicesOfTimeAreLeftToStepEnds() {
    Tape tape = new Tape(List.of(call(MathFunction.STEP, new Time())));
    assertThat(new TapePieces(tape, 1).choiceCount()).isZero();
    assertThat(TapePieces.ofTime(tape).choiceCount()).isOne();
  }

  /** Returns what is found along a way of x and y. */
  private static List<Double> found(TapePieces pieces, Tape tape, double[] x, double[] y) {
    double[][] points = new double[3][];
    for (int k = 0; k < 3; k++) {
      double[] leaves = new double[tape.leaves().size()];
      for (int leaf = 0; leaf < leaves.length; leaf++) {
        leaves[leaf] = tape.leaves().get(leaf).equals(X) ? x[k] : y[k];
      }
      points[k] = pieces.newPoint();
      pieces.at(leaves, points[k]);
    }
    boolean decided = pieces.decide(points[0], points[1], points[2]);
    return List.of(
        decided ? 1.0 : 0,
        pieces.isEven() ? 1.0 : 0,
        (double) pieces.undecidedCount(),
        pieces.low(0),
        pieces.high(0));
  }

  @Test
  void aWayIsDecidedByItselfAndNotByTheOneBefore() {
    Expression power = new Expression.Power(X, Expression.of(9));
    for (Expression formula :
        List.of(
            new Product(power, call(MathFunction.ABS, Y)),
            new Sum(call(MathFunction.EXP, X), new Product(X, Y)),
            new Product(positive(X), new Expression.Quotient(Y, new Sum(X, Y))))) {
      Tape tape = new Tape(List.of(formula));
      TapePieces used = new TapePieces(tape, 1);
      for (double size : new double[] {1e-6, 3, 1e-7, 0.5, 2, 1e-3}) {
        double[] x = {0.1 * size, size, 1.9 * size};
        double[] y = {-size, 0.4 * size, 1.7};
        assertThat(found(used, tape, x, y))
            .as("%s, %s", formula, size)
            .isEqualTo(found(new TapePieces(tape, 1), tape, x, y));
      }
    }
  }

  @Test
  void boundsHoldTheValuesOfTheFormula() {
    Random random = new Random(5);
    Expression formula =
        new Sum(
            new Product(new Sum(X, Expression.of(-0.3)), new Product(Y, Y)),
            new Product(call(MathFunction.COS, X), new Expression.Negation(Y)));
    Tape tape = new Tape(List.of(formula));
    TapePieces pieces = new TapePieces(tape, 1);
    double[] point = pieces.newPoint();
    for (int k = 0; k < 2000; k++) {
      double[] low = {random.nextDouble() * 4 - 2, random.nextDouble() * 4 - 2};
      double[] high = {low[0] + random.nextDouble(), low[1] + random.nextDouble()};
      double[] leaves = new double[2];
      for (int leaf = 0; leaf < 2; leaf++) {
        pieces.setLeaf(leaf, low[leaf], high[leaf]);
        leaves[leaf] = low[leaf] + random.nextInt(3) / 2.0 * (high[leaf] - low[leaf]);
      }
      pieces.decide();
      pieces.at(leaves, point);
      assertThat(pieces.value(0, point)).isBetween(pieces.low(0), pieces.high(0));
    }
  }

  @Test
  void boundsOfAPointHoldTheExactValue() {
    Random random = new Random(6);
    Tape tape = new Tape(List.of(new Product(new Sum(X, Y), X)));
    TapePieces pieces = new TapePieces(tape, 1);
    for (int k = 0; k < 200; k++) {
      double[] at = {random.nextDouble(), 1e3 * random.nextDouble()};
      for (int leaf = 0; leaf < 2; leaf++) {
        double value = tape.leaves().get(leaf).equals(X) ? at[0] : at[1];
        pieces.setLeaf(leaf, value, value);
      }
      pieces.decide();
      BigDecimal x = new BigDecimal(at[0]);
      BigDecimal exact = x.add(new BigDecimal(at[1])).multiply(x);
      assertThat(exact).isBetween(new BigDecimal(pieces.low(0)), new BigDecimal(pieces.high(0)));
    }
  }

  /** x and y pass through zero on curves; three values of their product do not show its size. */
  @Test
  void aProductOfFactorsThatBothPassThroughZeroIsBoundedByThem() {
    Tape tape = new Tape(List.of(new Product(X, Y)));
    List<Double> found =
        found(new TapePieces(tape, 1), tape, new double[] {-1, -1, 1}, new double[] {1, -1, -1});
    // both lie in [−2, 2], one bow of 1 beside their values
    assertThat(found.get(3)).isCloseTo(-4, within(1e-12));
    assertThat(found.get(4)).isCloseTo(4, within(1e-12));
  }
}
