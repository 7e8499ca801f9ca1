package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What every solver that iterations can be given does, besides factors and solutions. */
abstract class LinearSolverContract extends FactorsContract {
  @Test
  void identityHasConditionOne() {
    assertThat(factored(4, (i, j) -> i == j ? 1 : 0).reciprocalCondition()).isEqualTo(1);
  }

  @Test
  void singularMatrixHasNoReciprocalCondition() {
    LinearSolver solver = factored(2, (i, j) -> i == j ? 1 : 0);
    solver.factor(matrix(solver, (i, j) -> 1));
    assertThat(solver.reciprocalCondition()).isZero();
  }

  @Test
  void nothingHasConditionOne() {
    LinearSolver solver = create(0);
    solver.factor(new double[0]);
    assertThat(solver.reciprocalCondition()).isEqualTo(1);
  }

  @ParameterizedTest
  @ValueSource(ints = {-900, -1, 1, 900})
  void scalingByAPowerOfTwoLeavesTheCondition(int exponent) {
    Element a = random(6, new Random(SEED));
    double plain = factored(6, a).reciprocalCondition();
    double scaled = factored(6, (i, j) -> Math.scalb(a.at(i, j), exponent)).reciprocalCondition();
    assertThat(scaled).isEqualTo(plain);
  }

  @Test
  void conditionAllocatesNothing() {
    LinearSolver solver = factored(10, random(10, new Random(SEED)));
    double[] condition = new double[1];
    assertThat(allocatedBy(() -> condition[0] = solver.reciprocalCondition())).isZero();
    assertThat(condition[0]).isPositive();
  }

  @Test
  void columnThatRepeatsAnotherIsReported() {
    LinearSolver solver = create(4);
    // Columns 1 and 3 are equal; powers of two are eliminated without rounding.
    double[][] a = {{1, 2, 4, 2}, {2, 1, 1, 1}, {4, 1, 2, 1}, {1, 4, 1, 4}};
    assertThat(solver.factor(matrix(solver, (i, j) -> a[i][j]))).isEqualTo(3);
  }

  @Test
  void matrixOfTheWrongLengthIsRefused() {
    LinearSolver solver = create(3);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> solver.factor(new double[2]))
        .withMessage("the matrix has 2 elements; it must have " + solver.layout().length());
  }
}
