package org.mechservice.solver.closure.assembly;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.linear.SparseMatrix;

/** What large mechanisms are set up by, against what small ones are. */
class LargeAssemblyTest {
  /** Rows of unit length with a few elements in a band, and rows that follow from them. */
  private static SparseMatrix rows(long seed, int m, int n, int repeated, double weak) {
    Random random = new Random(seed);
    double[][] dense = new double[m][n];
    for (int i = 0; i < m - repeated; i++) {
      for (int e = 0; e < 4; e++) {
        dense[i][Math.floorMod(i + random.nextInt(9) - 2, n)] += 2 * random.nextDouble() - 1;
      }
      dense[i][i % n] += 1;
    }
    for (int i = m - repeated; i < m; i++) {
      int first = random.nextInt(m - repeated);
      int second = random.nextInt(m - repeated);
      for (int j = 0; j < n; j++) {
        dense[i][j] = dense[first][j] - dense[second][j] / 2;
      }
    }
    if (weak > 0) {
      // the second row is the first but for a part in a column of its own
      dense[1] = dense[0].clone();
      dense[1][n - 1] += weak;
    }
    return ofUnitRows(dense, n);
  }

  private static SparseMatrix ofUnitRows(double[][] dense, int n) {
    List<int[]> pattern = new ArrayList<>();
    for (double[] row : dense) {
      double length = Math.sqrt(Arrays.stream(row).map(x -> x * x).sum());
      for (int j = 0; j < n; j++) {
        row[j] = length > 0 ? row[j] / length : 0;
      }
      pattern.add(IntStream.range(0, n).filter(j -> row[j] != 0).toArray());
    }
    SparseMatrix matrix = SparseMatrix.of(pattern.toArray(int[][]::new), n);
    for (int i = 0; i < dense.length; i++) {
      matrix.setRow(i, dense[i], 0);
    }
    return matrix;
  }

  private static double[] dense(SparseMatrix matrix) {
    double[] dense = new double[matrix.rows() * matrix.columns()];
    matrix.toDense(dense, matrix.columns());
    return dense;
  }

  @ParameterizedTest
  @CsvSource({
    "1, 30, 40, 0, 0",
    "2, 30, 40, 5, 0",
    "3, 40, 40, 12, 0",
    "4, 30, 40, 3, 1e-4",
    "5, 30, 40, 3, 1e-6",
    "6, 30, 40, 3, 1e-11",
    "7, 30, 40, 0, 1e-7",
    "8, 120, 150, 40, 1e-3",
    "9, 20, 12, 0, 0"
  })
  void rankIsThatOfTheSingularValues(long seed, int m, int n, int repeated, double weak) {
    SparseMatrix matrix = rows(seed, m, n, repeated, weak);
    IndependentRows few = new SparseIndependentRows(matrix, n);
    IndependentRows all = new DenseIndependentRows(dense(matrix), m, n);
    assertThat(few.rank()).isEqualTo(all.rank());
    assertThat(few.redundant()).hasSize(m - few.rank()).isSorted();
    assertThat(withoutRedundant(matrix, few).rank()).isEqualTo(few.rank());
    assertThat(few.smallestPivot()).isBetween(all.smallestPivot() / 30, 30 * all.smallestPivot());
  }

  /**
   * Loops that share no coordinate, each with five rows of which two or three are independent up to
   * a change of the others by {@code weak}: as those of stacked overconstrained linkages.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0, 1e-15, 1e-11, 1e-6, 1e-3})
  void rowsOfSeparateLoopsHaveTheRankOfAll(double weak) {
    int loops = 12;
    double[][] rows = new double[5 * loops][4 * loops];
    Random random = new Random(5);
    for (int loop = 0; loop < loops; loop++) {
      for (int i = 0; i < 5; i++) {
        int like = i - 2 - loop % 2;
        for (int j = 4 * loop; j < 4 * loop + 4; j++) {
          double element = random.nextDouble() - 0.5;
          rows[5 * loop + i][j] = like < 0 ? element : rows[5 * loop + like][j] + weak * element;
        }
      }
    }
    SparseMatrix matrix = ofUnitRows(rows, 4 * loops);
    IndependentRows few = new SparseIndependentRows(matrix, 4 * loops);
    IndependentRows all = new DenseIndependentRows(dense(matrix), 5 * loops, 4 * loops);
    assertThat(few.rank()).isEqualTo(all.rank());
    assertThat(few.redundant()).hasSize(5 * loops - few.rank()).isSorted();
    assertThat(withoutRedundant(matrix, few).rank()).isEqualTo(few.rank());
    assertThat(few.smallestPivot()).isBetween(all.smallestPivot() / 30, 30 * all.smallestPivot());
  }

  /** The rows that are not redundant have the whole rank. */
  private static IndependentRows withoutRedundant(SparseMatrix matrix, IndependentRows found) {
    double[] kept = dense(matrix);
    for (int row : found.redundant()) {
      Arrays.fill(kept, row * matrix.columns(), (row + 1) * matrix.columns(), 0);
    }
    return new DenseIndependentRows(kept, matrix.rows(), matrix.columns());
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 7})
  void theLeastMoveIsThatOfTheSingularValues(int repeated) {
    SparseMatrix matrix = rows(10 + repeated, 40, 60, repeated, 0);
    LeastMoves sparse = new SparseLeastMoves(matrix, 60);
    LeastMoves dense = new DenseLeastMoves(40, 60);
    sparse.take(matrix);
    dense.take(matrix);
    double[] move = new Random(3).doubles(60, -1, 1).toArray();
    double[] right = new double[40];
    Arrays.setAll(right, i -> matrix.product(i, move, 0));
    double[] expected = new double[60];
    double[] actual = new double[60];
    for (double damping : new double[] {0, 1e-3}) {
      dense.solve(damping, right, expected);
      sparse.solve(damping, right, actual);
      for (int j = 0; j < 60; j++) {
        // damping is relative to bounds of the size of A that differ, so that half a part may
        double allowed = damping > 0 ? 0.2 : 1e-9;
        assertThat(actual[j] - expected[j]).isBetween(-allowed, allowed);
      }
    }
  }

  @Test
  void equationsThatAskForNothingMoveNothing() {
    SparseMatrix zero = SparseMatrix.of(new int[][] {{0, 1}, {1}}, 2);
    LeastMoves sparse = new SparseLeastMoves(zero, 2);
    sparse.take(zero);
    double[] x = {5, 5};
    sparse.solve(0, new double[] {1, 1}, x);
    assertThat(x).containsOnly(0);
  }

  @Test
  void oneRedundantEquationIsToldInTheSingular() {
    LoopFinding.Kind kind = LoopFinding.Kind.REDUNDANT;
    assertThat(new LoopFinding(kind, "constraint \"end\"", 1, "1", 0).message())
        .startsWith("One equation of the loops follows from the others");
    assertThat(new LoopFinding(kind, "constraints", 2, "1", 0).message())
        .startsWith("2 equations of the loops follow from the others");
  }
}
