package org.mechservice.solver.linear.spectrum;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SingularValuesTest {
  private static final long SEED = 515;

  private static double[] random(int m, int n) {
    return new Random(SEED + 100L * m + n).doubles((long) m * n, -1, 1).toArray();
  }

  /** A matrix of the given rank, from random factors. */
  private static double[] ofRank(int rank, int m, int n) {
    double[] left = random(m, rank);
    double[] right = random(rank, n);
    double[] product = new double[m * n];
    for (int i = 0; i < m; i++) {
      for (int j = 0; j < n; j++) {
        for (int k = 0; k < rank; k++) {
          product[i * n + j] += left[i * rank + k] * right[k * n + j];
        }
      }
    }
    return product;
  }

  private static double[] times(double[] a, int m, int n, double[] x) {
    double[] product = new double[m];
    for (int i = 0; i < m; i++) {
      for (int j = 0; j < n; j++) {
        product[i] += a[i * n + j] * x[j];
      }
    }
    return product;
  }

  @ParameterizedTest
  @CsvSource({"1, 1", "3, 3", "4, 9", "9, 4", "12, 20"})
  void valuesAreThoseOfAnIndependentDecomposition(int m, int n) {
    double[] a = random(m, n);
    SingularValues singular = new SingularValues(m, n);
    singular.decompose(a);
    Array2DRowRealMatrix matrix = new Array2DRowRealMatrix(m, n);
    for (int i = 0; i < m * n; i++) {
      matrix.setEntry(i / n, i % n, a[i]);
    }
    double[] expected = new SingularValueDecomposition(matrix).getSingularValues();
    for (int k = 0; k < Math.min(m, n); k++) {
      assertThat(singular.value(k)).isCloseTo(expected[k], within(1e-13 * expected[0]));
    }
  }

  @ParameterizedTest
  @CsvSource({"5, 5, 7", "2, 5, 7", "3, 8, 4", "1, 6, 6", "5, 12, 20"})
  void rankIsThatOfTheFactorsItWasMadeOf(int rank, int m, int n) {
    int expected = Math.min(rank, Math.min(m, n));
    SingularValues singular = new SingularValues(m, n);
    singular.decompose(ofRank(rank, m, n));
    assertThat(singular.rank(1e4, 1e-9)).isEqualTo(expected);
  }

  @Test
  void matrixOfZerosHasRankZero() {
    SingularValues singular = new SingularValues(3, 4);
    singular.decompose(new double[12]);
    assertThat(singular.rank(1e4, 1e-9)).isZero();
  }

  @Test
  void solutionIsTheSmallestThatSolvesConsistentEquations() {
    int m = 6;
    int n = 9;
    int rank = 4;
    double[] a = ofRank(rank, m, n);
    double[] inRange = times(a, m, n, random(n, 1));
    SingularValues singular = new SingularValues(m, n);
    singular.decompose(a);
    double[] x = new double[n];
    singular.solve(rank, inRange, x);
    assertThat(times(a, m, n, x)).containsExactly(inRange, within(1e-12));
    // The smallest solution is a combination of rows: x = Aᵀ y.
    double[] y = new double[m];
    singular.solveTransposed(rank, x, y);
    double[] combination = new double[n];
    for (int i = 0; i < m; i++) {
      for (int j = 0; j < n; j++) {
        combination[j] += a[i * n + j] * y[i];
      }
    }
    assertThat(combination).containsExactly(x, within(1e-12));
  }
}
