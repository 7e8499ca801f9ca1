package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SparseSymmetricTest {
  private static final int[] NONE = {};

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void solvesLikeDenseFactors(long seed) {
    Random random = new Random(seed);
    int n = 40;
    List<int[]> cliques = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      cliques.add(random.ints(0, n).distinct().limit(1 + random.nextInt(4)).sorted().toArray());
    }
    int[] first = seed % 2 == 0 ? NONE : new int[] {17, 3, 25};
    SparseSymmetric sparse = new SparseSymmetric(n, cliques, first);
    for (int k = 0; k < first.length; k++) {
      assertThat(sparse.rowAt(k)).isEqualTo(first[k]);
    }
    double[] dense = new double[n * n];
    for (int[] clique : cliques) {
      int[] places = Arrays.stream(clique).map(sparse::placeOf).sorted().toArray();
      double[] x = random.doubles(places.length, -1, 1).toArray();
      sparse.addSquare(places, 0, x, 0, x.length, 2);
      for (int i = 0; i < x.length; i++) {
        for (int j = 0; j < x.length; j++) {
          dense[n * sparse.rowAt(places[i]) + sparse.rowAt(places[j])] += 2 * x[i] * x[j];
        }
      }
    }
    for (int i = 0; i < n; i++) {
      sparse.addDiagonal(sparse.placeOf(i), 0.1);
      dense[n * i + i] += 0.1;
    }
    double norm = 0;
    for (int i = 0; i < n; i++) {
      norm = Math.max(norm, Arrays.stream(dense, n * i, n * i + n).map(Math::abs).sum());
    }
    assertThat(sparse.norm()).isCloseTo(norm, offset(1e-12));
    assertThat(sparse.factor()).isEqualTo(SparseSymmetric.POSITIVE_DEFINITE);
    Cholesky cholesky = new Cholesky(n);
    cholesky.factor(dense);
    double[] expected = random.doubles(n, -1, 1).toArray();
    double[] actual = expected.clone();
    cholesky.solve(expected, 0);
    sparse.solve(actual);
    for (int i = 0; i < n; i++) {
      // the condition is below 1e3
      assertThat(actual[i]).isCloseTo(expected[i], offset(1e-11));
    }
  }

  /** An arrow: the row that all others are coupled with comes last, and nothing is new. */
  @Test
  void leastDegreeKeepsTheHubOfAStarForLast() {
    List<int[]> cliques = new ArrayList<>();
    for (int i = 1; i < 30; i++) {
      cliques.add(new int[] {0, i});
    }
    SparseSymmetric star = new SparseSymmetric(30, cliques, NONE);
    assertThat(star.placeOf(0)).isGreaterThanOrEqualTo(28);
    assertThat(star.start(30)).isEqualTo(29);
  }

  @Test
  void aRowThatRepeatsAnotherHasNoPivot() {
    SparseSymmetric matrix = new SparseSymmetric(2, List.of(new int[] {0, 1}), NONE);
    matrix.addSquare(new int[] {0, 1}, 0, new double[] {1, 2}, 0, 2, 1);
    int singular = matrix.factor();
    assertThat(singular).isEqualTo(matrix.rowAt(1));
  }
}
