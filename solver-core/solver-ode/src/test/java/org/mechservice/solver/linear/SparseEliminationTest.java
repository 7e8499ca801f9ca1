package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.linear.spectrum.SingularValues;

class SparseEliminationTest {
  /** Far above rounding of a few additions, far below the pivots of these matrices. */
  private static final double ROUNDING = 1e-9;

  @ParameterizedTest
  @CsvSource({"1, 20, 30, 0", "2, 30, 30, 4", "3, 60, 40, 25", "4, 10, 50, 9", "5, 200, 230, 17"})
  void findsAsManyPivotsAsThereAreSingularValues(long seed, int m, int n, int repeated) {
    SparseMatrix matrix = RandomSparse.of(seed, m, n, repeated);
    double[] dense = new double[m * n];
    matrix.toDense(dense, n);
    SingularValues singular = new SingularValues(m, n);
    singular.decompose(dense);
    SparseElimination elimination = new SparseElimination(m, n);
    int found = elimination.eliminate(matrix, m, ROUNDING);
    assertThat(found).isEqualTo(singular.rank(1e4, 1e-8));
    assertThat(elimination.largestLeft()).isLessThan(ROUNDING);
  }

  /** What is found from other columns changes by a bounded multiple of them. */
  @ParameterizedTest
  @ValueSource(longs = {6, 7, 8})
  void pivotsAreLargeBesideWhatTheirRowsHaveLeft(long seed) {
    SparseMatrix matrix = RandomSparse.of(seed, 40, 60, 0);
    SparseElimination elimination = new SparseElimination(40, 60);
    assertThat(elimination.eliminate(matrix, 40, 0)).isEqualTo(40);
    double smallest = elimination.smallestPivot();
    assertThat(smallest).isGreaterThan(1e-3);
    assertThat(elimination.pivot(elimination.weakest())).isEqualTo(smallest);
    boolean[] columns = new boolean[60];
    for (int k = 0; k < 40; k++) {
      assertThat(columns[elimination.column(k)]).isFalse();
      columns[elimination.column(k)] = true;
    }
    int[] rows = new int[40];
    Arrays.setAll(rows, elimination::row);
    assertThat(rows).containsExactlyInAnyOrder(range(40));
  }

  private static int[] range(int count) {
    int[] all = new int[count];
    Arrays.setAll(all, i -> i);
    return all;
  }

  /** A long band is eliminated without new elements beyond it: the length of rows stays bounded. */
  @ParameterizedTest
  @ValueSource(ints = {100, 1000})
  void aBandStaysABand(int n) {
    int[][] pattern = new int[n][];
    for (int i = 0; i < n; i++) {
      pattern[i] =
          i == 0
              ? new int[] {0, 1}
              : i + 1 < n ? new int[] {i - 1, i, i + 1} : new int[] {i - 1, i};
    }
    SparseMatrix matrix = SparseMatrix.of(pattern, n);
    for (int i = 0; i < n; i++) {
      for (int e = matrix.start[i]; e < matrix.start[i + 1]; e++) {
        matrix.value[e] = matrix.column[e] == i ? 2.5 : -1;
      }
    }
    SparseElimination elimination = new SparseElimination(n, n);
    assertThat(elimination.eliminate(matrix, n, 0)).isEqualTo(n);
    int longest = 0;
    for (int k = 0; k < n; k++) {
      longest = Math.max(longest, elimination.upper(k).length);
    }
    assertThat(longest).isLessThanOrEqualTo(3);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, Double.NaN, Double.POSITIVE_INFINITY})
  void aRowWithoutFiniteElementsHasNoPivot(double element) {
    SparseMatrix matrix = SparseMatrix.of(new int[][] {{0, 1}, {1}}, 2);
    matrix.setRow(0, new double[] {1, 1}, 0);
    matrix.setRow(1, new double[] {0, element}, 0);
    SparseElimination elimination = new SparseElimination(2, 2);
    assertThat(elimination.eliminate(matrix, 2, 0)).isLessThan(2);
  }
}
