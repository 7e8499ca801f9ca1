package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CholeskyTest {
  private static final long SEED = 88;

  /** B Bᵀ for a random B. */
  private static double[] positiveDefinite(int n) {
    double[] b = new Random(SEED + n).doubles((long) n * n, -1, 1).toArray();
    double[] a = new double[n * n];
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        for (int k = 0; k < n; k++) {
          a[i * n + j] += b[i * n + k] * b[j * n + k];
        }
      }
    }
    return a;
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 5, 20})
  void solutionSolvesTheEquations(int n) {
    double[] a = positiveDefinite(n);
    double[] expected = new Random(SEED).doubles(n).toArray();
    double[] b = new double[n + 2];
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        b[2 + i] += a[i * n + j] * expected[j];
      }
    }
    Cholesky cholesky = new Cholesky(n);
    assertThat(cholesky.factor(a)).isEqualTo(Cholesky.POSITIVE_DEFINITE);
    double smallest = cholesky.smallestPivot();
    cholesky.solve(b, 2);
    for (int i = 0; i < n; i++) {
      // Errors grow by the condition, which the smallest pivot bounds roughly.
      assertThat(b[2 + i]).isCloseTo(expected[i], within(1e-14 * n / (smallest * smallest)));
    }
  }

  @Test
  void rowThatDependsOnThoseBeforeIsNamed() {
    // The third row is the sum of the first two.
    double[] a = {2, 1, 3, 1, 2, 3, 3, 3, 6};
    assertThat(new Cholesky(3).factor(a)).isEqualTo(2);
  }

  @Test
  void matrixThatIsNotFiniteIsRefused() {
    assertThat(new Cholesky(2).factor(new double[] {1, 0, Double.NaN, 1})).isEqualTo(1);
  }
}
