package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** What solvers do that factor a matrix as it is: the condition they tell is the matrix's own. */
abstract class LuFactorsContract extends LinearSolverContract {
  /** 1 / (i + j + 1), of condition 2.9070279e7 at n = 6. */
  private static double hilbert(int i, int j) {
    return 1.0 / (i + j + 1);
  }

  @Test
  void conditionOfADiagonalMatrixIsTheRatioOfItsElements() {
    double[] diagonal = {1, 1e-8, 1e4, 1};
    LinearSolver solver = factored(4, (i, j) -> i == j ? diagonal[i] : 0);
    assertThat(solver.reciprocalCondition()).isCloseTo(1e-12, within(1e-26));
  }

  @Test
  void conditionOfTheHilbertMatrixIsTheOnePublished() {
    // Symmetric: row and column norm agree; Higham 2002, ch. 28.
    double reciprocal = factored(6, LuFactorsContract::hilbert).reciprocalCondition();
    assertThat(reciprocal).isCloseTo(1 / 2.9070279e7, within(1e-6 / 2.9070279e7));
  }

  @Test
  void estimateIsAtMostThreeTimesTheConditionOff() {
    for (int trial = 0; trial < 50; trial++) {
      Element a = random(12, new Random(SEED + trial));
      double exact = exactReciprocalCondition(12, a);
      double estimate = factored(12, a).reciprocalCondition();
      assertThat(estimate).as("trial " + trial).isBetween(exact * (1 - 1e-9), 3 * exact);
    }
  }

  private double exactReciprocalCondition(int n, Element a) {
    LinearSolver solver = factored(n, a);
    double[] rowOfInverse = new double[n];
    double[] row = new double[n];
    for (int j = 0; j < n; j++) {
      double[] column = unit(n, j);
      solver.solve(column);
      for (int i = 0; i < n; i++) {
        rowOfInverse[i] += Math.abs(column[i]);
        row[i] += Math.abs(a.at(i, j));
      }
    }
    return 1 / (Arrays.stream(row).max().orElse(1) * Arrays.stream(rowOfInverse).max().orElse(1));
  }
}
