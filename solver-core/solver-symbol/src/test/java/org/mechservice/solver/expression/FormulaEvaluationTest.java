package org.mechservice.solver.expression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.expression.Expression.Argument;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.CoordinatePosition;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Expression.Power;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Quotient;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.spatial.Powers;
import org.mechservice.solver.symbol.MathFunction;

class FormulaEvaluationTest {
  private static final Expression T = new Time();
  private static final Expression Q = new CoordinatePosition(new JointCoordinate(0, 0));
  private static final Expression P = new ParameterValue(0);

  /** Every function, with arguments where it is smooth and not zero. */
  static Stream<Expression> everyOperation() {
    Expression mixed = new Sum(new Product(T, Q), P);
    Expression inside = new Quotient(mixed, new Sum(Expression.of(8), new Product(Q, Q)));
    Stream<Expression> calls =
        MathFunction.inFormulas().stream()
            .map(f -> Expression.call(f, List.of(inside, new Product(T, P)).subList(0, f.arity())));
    Expression base = new Sum(new Product(T, T), Expression.of(0.5));
    return Stream.concat(
        calls,
        Stream.of(
            mixed,
            inside,
            new Negation(mixed),
            new Power(base, Expression.of(2)),
            new Power(base, Expression.of(3)),
            new Power(base, Expression.of(-1.5)),
            new Power(base, inside)));
  }

  /** What is steep or has no value where a branch leaves it out, with q between 0 and 1. */
  static Stream<Expression> branchesNotTaken() {
    Expression negative = new Sum(Q, Expression.of(-2));
    Expression cut = new Call(MathFunction.MAX, List.of(negative, Expression.ZERO));
    Expression steep = new Call(MathFunction.SQRT, List.of(cut));
    Expression origin = new Call(MathFunction.STEP, List.of(negative));
    return Stream.of(
        steep,
        new Power(cut, Expression.of(0.3)),
        new Product(cut, steep),
        new Call(MathFunction.ASIN, List.of(new Sum(cut, Expression.of(1)))),
        new Call(MathFunction.MAX, List.of(steep, Expression.of(1))),
        new Call(MathFunction.MIN, List.of(Expression.of(-1), steep)),
        new Call(MathFunction.ABS, List.of(steep)),
        new Call(MathFunction.ATAN2, List.of(cut, origin)),
        new Quotient(
            Expression.of(1),
            new Sum(
                Expression.of(1),
                new Call(MathFunction.EXP, List.of(new Product(Expression.of(2000), Q))))));
  }

  @MethodSource("branchesNotTaken")
  @ParameterizedTest
  void whatIsNotTakenHasNoSlopeRateNorBend(Expression expression) {
    FormulaEvaluation evaluation = new FormulaEvaluation(List.of(expression));
    double[] gradient = {1};
    double[] change = {1};
    evaluation.setLeaf(0, 0.7, 1.3, -0.4);
    evaluation.derivatives();
    evaluation.rates();
    evaluation.gradient(0, gradient);
    evaluation.gradientChange(0, new double[] {0.8}, change);
    assertThat(evaluation.rate(0)).isZero();
    assertThat(evaluation.secondRate(0)).isZero();
    assertThat(gradient[0]).isZero();
    assertThat(change[0]).isZero();
  }

  @MethodSource("everyOperation")
  @ParameterizedTest
  void gradientIsTheDifferenceQuotient(Expression expression) {
    FormulaEvaluation evaluation = new FormulaEvaluation(List.of(expression));
    double[] at = {0.7, 1.1, 0.9};
    int leaves = evaluation.leaves().size();
    double[] gradient = new double[leaves];
    set(evaluation, at);
    evaluation.derivatives();
    evaluation.gradient(0, gradient);
    for (int i = 0; i < leaves; i++) {
      double difference = derivative(evaluation, at, i);
      // Richardson at step 1e-3: truncation 1e-12, rounding 1e-13 of values of order 1
      assertThat(gradient[i]).as("leaf %d", i).isCloseTo(difference, within(1e-10));
    }
  }

  @MethodSource("everyOperation")
  @ParameterizedTest
  void ratesAreDerivativesAlongTheTrajectory(Expression expression) {
    FormulaEvaluation evaluation = new FormulaEvaluation(List.of(expression));
    double[] x = {0.7, 1.1, 0.9};
    double[] first = {0.3, -0.4, 0.5};
    double[] second = {0.2, 0.6, -0.1};
    for (int i = 0; i < evaluation.leaves().size(); i++) {
      evaluation.setLeaf(i, x[i], first[i], second[i]);
    }
    evaluation.derivatives();
    evaluation.rates();
    double rate = evaluation.rate(0);
    double secondRate = evaluation.secondRate(0);
    double h = 2e-3;
    double[] values = new double[5];
    for (int k = -2; k <= 2; k++) {
      double[] moved = new double[3];
      for (int i = 0; i < 3; i++) {
        moved[i] = x[i] + k * h * first[i] + 0.5 * k * h * k * h * second[i];
      }
      set(evaluation, moved);
      evaluation.values();
      values[k + 2] = evaluation.value(0);
    }
    double byFirst = (values[0] - 8 * values[1] + 8 * values[3] - values[4]) / (12 * h);
    double bySecond =
        (-values[0] + 16 * values[1] - 30 * values[2] + 16 * values[3] - values[4]) / (12 * h * h);
    // fourth order: truncation h⁴ times derivatives of order 1 … 10, rounding 1e-15 / h²
    assertThat(rate).isCloseTo(byFirst, within(1e-9));
    assertThat(secondRate).isCloseTo(bySecond, within(5e-9));
  }

  @MethodSource("everyOperation")
  @ParameterizedTest
  void gradientChangeIsTheDifferenceOfGradients(Expression expression) {
    FormulaEvaluation evaluation = new FormulaEvaluation(List.of(expression));
    int leaves = evaluation.leaves().size();
    double[] at = {0.7, 1.1, 0.9};
    double[] direction = {0.6, -0.8, 0.3};
    double[] change = new double[leaves];
    set(evaluation, at);
    evaluation.derivatives();
    evaluation.gradientChange(0, direction, change);
    double h = 1e-3;
    double[][] gradients = new double[4][leaves];
    int[] steps = {-2, -1, 1, 2};
    for (int k = 0; k < 4; k++) {
      double[] moved = at.clone();
      for (int i = 0; i < 3; i++) {
        moved[i] += steps[k] * h * direction[i];
      }
      set(evaluation, moved);
      evaluation.derivatives();
      evaluation.gradient(0, gradients[k]);
    }
    for (int i = 0; i < leaves; i++) {
      double difference =
          (gradients[0][i] - 8 * gradients[1][i] + 8 * gradients[2][i] - gradients[3][i])
              / (12 * h);
      assertThat(change[i]).as("leaf %d", i).isCloseTo(difference, within(1e-9));
    }
  }

  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
  @ParameterizedTest
  void randomFormulasHaveTheirGradients(long seed) {
    Random random = new Random(seed);
    FormulaEvaluation evaluation = new FormulaEvaluation(List.of(formula(random, 6)));
    double[] at = {0.7, 1.1, 0.9};
    double[] gradient = new double[evaluation.leaves().size()];
    set(evaluation, at);
    evaluation.derivatives();
    evaluation.gradient(0, gradient);
    for (int i = 0; i < gradient.length; i++) {
      double scale = 1 + Math.abs(gradient[i]) + Math.abs(evaluation.value(0));
      assertThat(gradient[i]).isCloseTo(derivative(evaluation, at, i), within(1e-8 * scale));
    }
  }

  /** Bounded functions only, so that differences stay accurate. */
  private static Expression formula(Random random, int depth) {
    if (depth == 0) {
      return List.of(T, Q, P, Expression.of(random.nextDouble())).get(random.nextInt(4));
    }
    Expression a = formula(random, depth - 1);
    Expression b = formula(random, depth - 1);
    return switch (random.nextInt(6)) {
      case 0 -> new Sum(a, b);
      case 1 -> new Product(new Call(MathFunction.TANH, List.of(a)), b);
      case 2 -> new Quotient(a, new Sum(Expression.of(2), new Product(b, b)));
      case 3 -> new Call(MathFunction.SIN, List.of(new Sum(a, b)));
      case 4 -> new Call(MathFunction.ATAN2, List.of(a, new Sum(Expression.of(9), b)));
      default -> new Negation(new Call(MathFunction.ATAN, List.of(new Product(a, b))));
    };
  }

  @Test
  void equalPartsAreEvaluatedOnceAndConstantsInAdvance() {
    Expression sine = new Call(MathFunction.SIN, List.of(new Product(Expression.of(2), T)));
    Expression sameSine = new Call(MathFunction.SIN, List.of(new Product(Expression.of(2), T)));
    Expression constant =
        new Call(MathFunction.EXP, List.of(new Sum(Expression.of(1), Expression.of(1))));
    List<Expression> formulas = List.of(new Sum(sine, sameSine), constant);
    assertThat(new Tape(formulas).target).hasSize(3);
    assertThat(new FormulaPrograms(formulas).values().operationCount()).isEqualTo(2);
    assertThat(new FormulaEvaluation(formulas).value(1)).isEqualTo(StrictMath.exp(2));
  }

  @Test
  void sumOfManyTermsNeedsNoDeepStack() {
    Expression sum = T;
    for (int i = 0; i < 200_000; i++) {
      sum = new Sum(sum, i % 2 == 0 ? Q : T);
    }
    FormulaEvaluation evaluation = new FormulaEvaluation(List.of(sum));
    set(evaluation, new double[] {1, 2, 0});
    evaluation.values();
    assertThat(evaluation.value(0)).isEqualTo(1 + 100_000 * 3.0);
  }

  @Test
  void resultThatIsNotFiniteIsFound() {
    Expression bad = new Quotient(Expression.of(1), Expression.of(0));
    FormulaEvaluation evaluation = new FormulaEvaluation(List.of(T, bad));
    evaluation.setLeaf(0, 1);
    evaluation.values();
    assertThat(evaluation.firstNotFinite()).isEqualTo(1);
    evaluation.setLeaf(0, Double.NaN);
    evaluation.values();
    assertThat(evaluation.firstNotFinite()).isEqualTo(0);
  }

  @Test
  void powersOfZeroHaveTheirSlopes() {
    Expression argument = new Argument();
    FormulaEvaluation evaluation =
        new FormulaEvaluation(
            List.of(
                new Power(argument, Expression.of(1)),
                new Power(argument, Expression.of(2)),
                new Power(argument, Expression.of(3)),
                new Power(argument, Expression.of(0))));
    evaluation.setLeaf(0, 0, 1, 0);
    evaluation.derivatives();
    evaluation.rates();
    double[] rates = {
      evaluation.rate(0), evaluation.rate(1), evaluation.rate(2), evaluation.rate(3)
    };
    double[] second = {
      evaluation.secondRate(0), evaluation.secondRate(1), evaluation.secondRate(2)
    };
    assertThat(rates).containsExactly(1, 0, 0, 0);
    assertThat(second).containsExactly(0, 2, 0);
  }

  /** The error of exp(b ln a) is |b ln a| ulp; of a product, half the number of factors. */
  @CsvSource({
    "3, 5",
    "-3, 5",
    "-3, 4",
    "2, -7",
    "0, 3",
    "0, 0",
    "0, -1",
    "-0.0, -3",
    "4, 0.5",
    "4, -1.5",
    "1e-5, 1.5",
    "0.37, 2.2",
    "17, -3.3",
    "-2, 0.5",
    "-2, 101",
    "1.01, 1000.5",
    "0, 2.5",
    "1e300, 2",
    "1e-300, 2",
    "NaN, 2",
    "2, NaN",
    "1e300, 1.3",
    "0, -2.5",
    "-1.001, 101"
  })
  @ParameterizedTest
  void powersAreThoseOfTheLibrary(double a, double b) {
    double expected = StrictMath.pow(a, b);
    double ulps = 4 + Math.max(Math.abs(b) / 2, Math.abs(b * StrictMath.log(Math.abs(a))));
    double bound = Double.isFinite(ulps) ? ulps * Math.ulp(expected) : 0;
    double power = Powers.power(a, b);
    if (Double.isFinite(expected)) {
      assertThat(power).isCloseTo(expected, within(bound));
    } else {
      assertThat((Double) power).isEqualTo((Double) expected);
    }
  }

  @Test
  void evaluationAllocatesNothing() {
    FormulaEvaluation evaluation = new FormulaEvaluation(everyOperation().toList());
    double[] gradient = new double[evaluation.leaves().size()];
    double[] change = new double[gradient.length];
    double[] x = {0.7, 1.1, 0.9};
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long least = Long.MAX_VALUE;
    for (int round = 0; round < 20; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < 50; i++) {
        set(evaluation, x);
        evaluation.derivatives();
        evaluation.rates();
        evaluation.gradient(0, gradient);
        evaluation.gradientChange(0, gradient, change);
      }
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertThat(least).isZero();
  }

  private static void set(FormulaEvaluation evaluation, double[] x) {
    for (int i = 0; i < evaluation.leaves().size(); i++) {
      evaluation.setLeaf(i, x[i]);
    }
  }

  /** Central differences of two steps, extrapolated. */
  private static double derivative(FormulaEvaluation evaluation, double[] at, int leaf) {
    double h = 1e-3;
    double[] values = new double[4];
    int[] steps = {-2, -1, 1, 2};
    for (int k = 0; k < 4; k++) {
      double[] moved = at.clone();
      moved[leaf] += steps[k] * h;
      set(evaluation, moved);
      evaluation.values();
      values[k] = evaluation.value(0);
    }
    set(evaluation, at);
    evaluation.values();
    return (values[0] - 8 * values[1] + 8 * values[2] - values[3]) / (12 * h);
  }
}
