package org.mechservice.solver.closure.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.linear.SparseMatrix;

/** Sparse factors of J U² Jᵀ solve as dense ones do, rows of zeros included. */
final class PositionCorrectionTest {
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void sparseAndDenseFactorsAgree(long seed) {
    Random random = new Random(seed);
    int n = 30;
    int m = 12;
    int[][] columns = new int[m][];
    for (int row = 0; row < m; row++) {
      columns[row] = random.ints(0, n).distinct().limit(6).sorted().toArray();
    }
    SparseMatrix rows = SparseMatrix.of(columns, n);
    for (int e = 0; e < rows.start[m - 1]; e++) {
      rows.value[e] = random.nextGaussian();
    }
    double[] units = random.doubles(n, 0.5, 2).toArray();
    PositionCorrection dense = new DensePositionCorrection(rows, units);
    PositionCorrection sparse = new SparsePositionCorrection(rows, units);
    double[] expected = random.doubles(m, -1, 1).toArray();
    expected[m - 1] = 0;
    double[] actual = expected.clone();

    assertThat(dense.factor()).isTrue();
    assertThat(sparse.factor()).isTrue();
    dense.solve(expected);
    sparse.solve(actual);

    for (int row = 0; row < m; row++) {
      // a dozen random rows are far from dependent: some digits of 16 are lost, not eight
      assertThat(actual[row])
          .isCloseTo(expected[row], within(1e-8 * (1 + Math.abs(expected[row]))));
    }
  }
}
