package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class EquilibratedSolverTest extends LinearSolverContract {
  @Override
  protected LinearSolver create(int n) {
    return new EquilibratedSolver(new DenseLu(n));
  }

  @Test
  void unitsOfTheRowsDoNotDecideAboutTheCondition() {
    LinearSolver solver = create(3);
    LinearSolver scaled = create(3);
    double[] unit = {1, 1e200, 1e-200};
    solver.factor(matrix(solver, (i, j) -> i == j ? 2 : 1));
    scaled.factor(matrix(scaled, (i, j) -> unit[i] * (i == j ? 2 : 1)));
    // Scaled by powers of 2 the largest elements are from 1 to 2 times those of the other.
    assertThat(scaled.reciprocalCondition()).isCloseTo(solver.reciprocalCondition(), within(0.2));
  }

  @Test
  void bandIsSolvedAsIfItWereDense() {
    Random random = new Random(SEED);
    LinearSolver band = new EquilibratedSolver(new BandLu(new BandLayout(9, 1, 2)));
    LinearSolver dense = create(9);
    Element any = random(9, random);
    Element inside = (i, j) -> j - i >= -1 && j - i <= 2 ? Math.scalb(any.at(i, j), 20 * i) : 0;
    assertThat(band.factor(matrix(band, inside))).isEqualTo(LinearSolver.NONSINGULAR);
    dense.factor(matrix(dense, inside));
    double[] x = unit(9, 4);
    double[] expected = x.clone();
    band.solve(x);
    dense.solve(expected);
    // The same operations in the same order, but for the zeros.
    double size = Arrays.stream(expected).map(Math::abs).max().orElse(0);
    assertThat(x).containsExactly(expected, within(1e-12 * size));
  }

  @Test
  void unitsOfTheRowsDoNotDecideAboutThePivots() {
    // Unscaled, 1e10 would be the pivot of the first column and swallow the 1 beside the 1e20.
    LinearSolver solver = create(2);
    double[][] a = {{1e10, 1e20}, {1, 1}};
    solver.factor(matrix(solver, (i, j) -> a[i][j]));
    double[] b = {1e20, 2};
    solver.solve(b);
    assertThat(b).containsExactly(new double[] {1, 1}, within(2e-10));
  }
}
