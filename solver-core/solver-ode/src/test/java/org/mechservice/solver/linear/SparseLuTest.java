package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SparseLuTest {
  private static final int M = 50;
  private static final int N = 70;

  /** Residual of a solution over the size of its right side, pivots being above 1e-3. */
  private static final double EXACT = 1e-12;

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void solvesTheBlockThatWasChosenAlsoWhenItHasChanged(long seed) {
    SparseMatrix matrix = RandomSparse.of(seed, M, N, 0);
    SparseElimination chosen = new SparseElimination(M, N);
    assertThat(chosen.eliminate(matrix, M, 0)).isEqualTo(M);
    SparseLu factors = new SparseLu(chosen, M, N).sameOrder();
    Random random = new Random(seed);
    double[] ofRows = random.doubles(M, 0.5, 2).toArray();
    double[] ofColumns = random.doubles(N, 0.5, 2).toArray();
    for (int e = 0; e < matrix.value.length; e++) {
      matrix.value[e] *= 1 + 0.05 * random.nextDouble();
    }
    assertThat(factors.factor(matrix, ofRows, ofColumns)).isTrue();
    double[] right = random.doubles(M, -1, 1).toArray();

    double[] b = new double[M];
    Arrays.setAll(b, k -> right[factors.row(k)]);
    factors.solve(b);
    double[] x = new double[N];
    for (int k = 0; k < M; k++) {
      x[factors.column(k)] = b[k];
    }
    for (int i = 0; i < M; i++) {
      assertThat(matrix.product(i, x, 0)).isCloseTo(right[i], offset(EXACT * size(x)));
    }

    Arrays.setAll(b, k -> right[k]);
    double[] ofTransposed = b.clone();
    factors.solveTransposed(ofTransposed);
    double[] sum = new double[N];
    for (int k = 0; k < M; k++) {
      matrix.addRow(factors.row(k), ofTransposed[k], sum, 0);
    }
    for (int k = 0; k < M; k++) {
      assertThat(sum[factors.column(k)]).isCloseTo(right[k], offset(EXACT * size(ofTransposed)));
    }
  }

  private static double size(double[] x) {
    return 1 + Arrays.stream(x).map(Math::abs).max().orElse(0);
  }

  @ParameterizedTest
  @ValueSource(longs = {5, 6})
  void aBlockThatHasLostItsPivotIsSingular(long seed) {
    SparseMatrix matrix = RandomSparse.of(seed, M, N, 0);
    SparseElimination chosen = new SparseElimination(M, N);
    chosen.eliminate(matrix, M, 0);
    SparseLu factors = new SparseLu(chosen, M, N);
    double[] ones = new double[N];
    Arrays.fill(ones, 1);
    for (int e = matrix.start[7]; e < matrix.start[8]; e++) {
      matrix.value[e] = 0;
    }
    assertThat(factors.factor(matrix, ones, ones)).isFalse();
  }
}
