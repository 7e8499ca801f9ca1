package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A full pattern does what every solver does; a sparse one solves the same as dense factors. */
class SparsePivotedLuTest extends LuFactorsContract {
  @Override
  protected LinearSolver create(int n) {
    int[] all = IntStream.range(0, n).toArray();
    int[][] rows = new int[n][];
    Arrays.fill(rows, all);
    return new SparsePivotedLu(SparseLayout.of(rows));
  }

  /** A pattern with a number of elements in each column at random, also on its diagonal. */
  private static int[][] random(int n, int perColumn, Random random) {
    int[][] rows = new int[n][];
    for (int j = 0; j < n; j++) {
      rows[j] =
          IntStream.range(0, perColumn).map(k -> random.nextInt(n)).sorted().distinct().toArray();
    }
    return rows;
  }

  private static int[][] grid(int m) {
    int[][] rows = new int[m * m][];
    for (int k = 0; k < m * m; k++) {
      int own = k;
      rows[k] =
          IntStream.of(k - m, k - 1, k, k + 1, k + m)
              .filter(i -> i >= 0 && i < m * m)
              .filter(i -> i / m == own / m || i % m == own % m)
              .toArray();
    }
    return rows;
  }

  private static double[] elements(SparseLayout layout, double ofDiagonal, Random random) {
    double[] elements = new double[layout.length()];
    for (int j = 0; j < layout.dimension(); j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
        elements[layout.index(i, j)] = random.nextGaussian() * (i == j ? ofDiagonal : 1);
      }
    }
    return elements;
  }

  private static double[] full(SparseLayout layout, double[] elements) {
    int n = layout.dimension();
    double[] full = new double[n * n];
    for (int j = 0; j < n; j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
        full[i * n + j] = elements[layout.index(i, j)];
      }
    }
    return full;
  }

  @ParameterizedTest
  @CsvSource({"40, 3, 10", "40, 3, 1", "60, 4, 1e-3", "60, 6, 0", "80, 2, 1"})
  void sparseMatrixIsSolvedAsIfItWereDense(int n, int perColumn, double ofDiagonal) {
    Random random = new Random(SEED + n);
    int solved = 0;
    for (int trial = 0; trial < 20; trial++) {
      SparseLayout layout = SparseLayout.of(random(n, perColumn, random));
      SparsePivotedLu sparse = new SparsePivotedLu(layout);
      DenseLu dense = new DenseLu(n);
      for (int matrix = 0; matrix < 3; matrix++) {
        double[] elements = elements(layout, ofDiagonal, random);
        if (dense.factor(full(layout, elements)) != LinearSolver.NONSINGULAR
            || dense.reciprocalCondition() < 1e-8) {
          continue;
        }
        solved++;
        assertThat(sparse.factor(elements)).isEqualTo(LinearSolver.NONSINGULAR);
        double[] b = random.doubles(n).toArray();
        double[] x = b.clone();
        sparse.solve(x);
        double[] residual = b.clone();
        layout.addProduct(elements, Arrays.stream(x).map(v -> -v).toArray(), residual);
        double size = Arrays.stream(x).map(Math::abs).max().orElse(0);
        assertThat(residual).containsExactly(new double[n], within(1e-10 * (1 + size)));
        double[] transposed = b.clone();
        double[] expected = b.clone();
        sparse.solveTransposed(transposed);
        dense.solveTransposed(expected);
        double error = 1e-6 * Arrays.stream(expected).map(Math::abs).max().orElse(0);
        assertThat(transposed).containsExactly(expected, within(error));
        assertThat(sparse.reciprocalCondition())
            .isBetween(dense.reciprocalCondition() / 4, dense.reciprocalCondition() * 4);
      }
    }
    assertThat(solved).isPositive();
  }

  @Test
  void factorsDoNotDependOnTheMatrixBefore() {
    Random random = new Random(SEED);
    SparseLayout layout = SparseLayout.of(random(100, 4, random));
    SparsePivotedLu used = new SparsePivotedLu(layout);
    int solved = 0;
    for (int trial = 0; trial < 30; trial++) {
      double[] elements = elements(layout, trial % 3, random);
      SparsePivotedLu fresh = new SparsePivotedLu(layout);
      assertThat(used.factor(elements)).isEqualTo(fresh.factor(elements));
      if (fresh.reciprocalCondition() > 0) {
        double[] b = random.doubles(100).toArray();
        double[] x = b.clone();
        used.solve(x);
        fresh.solve(b);
        assertThat(x).isEqualTo(b);
        solved++;
      }
    }
    // Two matrices of three have elements on their diagonals, and are regular.
    assertThat(solved).isGreaterThanOrEqualTo(20);
  }

  @Test
  void orderEliminatesEveryColumnOnce() {
    Random random = new Random(SEED);
    for (int trial = 0; trial < 50; trial++) {
      int n = 1 + random.nextInt(300);
      SparseLayout layout = SparseLayout.of(random(n, 1 + random.nextInt(5), random));
      int[] order = MinimumDegree.order(layout);
      assertThat(Arrays.stream(order).sorted().toArray())
          .isEqualTo(IntStream.range(0, n).toArray());
    }
  }

  @Test
  void factorsOfAGridGrowLittleFasterThanTheGrid() {
    // n log n elements, 7.75 n log2 n for nested dissection; a band would have n √n.
    for (int m : new int[] {20, 60}) {
      SparseLayout layout = SparseLayout.of(grid(m));
      SparsePivotedLu lu = new SparsePivotedLu(layout);
      double[] elements = new double[layout.length()];
      for (int j = 0; j < m * m; j++) {
        for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
          elements[layout.index(i, j)] = i == j ? 5 : -1;
        }
      }
      assertThat(lu.factor(elements)).isEqualTo(LinearSolver.NONSINGULAR);
      double n = m * m;
      assertThat(lu.elements()).isLessThan((int) (3.5 * n * Math.log(n) / Math.log(2)));
    }
  }

  @Test
  void variableCoupledWithAllOthersIsEliminatedLast() {
    int n = 2000;
    int[][] rows = new int[n][];
    for (int j = 0; j < n; j++) {
      rows[j] =
          j == 7 ? IntStream.range(0, n).toArray() : new int[] {Math.min(7, j), Math.max(7, j)};
    }
    SparseLayout layout = SparseLayout.of(rows);
    assertThat(MinimumDegree.order(layout)[n - 1]).isEqualTo(7);
  }
}
