package org.mechservice.solver.linear.spectrum;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class EigenvaluesTest {
  static Stream<Object[]> sizesAndSeeds() {
    return IntStream.range(0, 24).mapToObj(i -> new Object[] {1 + i % 8 * (1 + i / 8), 300L + i});
  }

  private static double[] matrix(int n, long seed) {
    return new Random(seed).doubles((long) n * n, -1, 1).toArray();
  }

  /** ‖A v − λ v‖ against round-off of ‖A‖ ‖v‖, some hundred units for matrices of this size. */
  @MethodSource("sizesAndSeeds")
  @ParameterizedTest
  void vectorsAreOnlyStretched(int n, long seed) {
    double[] a = matrix(n, seed);
    assertResidual(n, a, 2e-13);
  }

  private static Eigenvalues assertResidual(int n, double[] a, double bound) {
    Eigenvalues eigen = new Eigenvalues(n, a);
    assertThat(eigen.converged()).isTrue();
    double norm = 0;
    for (double element : a) {
      norm = Math.max(norm, Math.abs(element));
    }
    double[] re = new double[n];
    double[] im = new double[n];
    for (int k = 0; k < n; k++) {
      eigen.vector(k, re, im);
      for (int i = 0; i < n; i++) {
        double sr = -eigen.real(k) * re[i] + eigen.imaginary(k) * im[i];
        double si = -eigen.real(k) * im[i] - eigen.imaginary(k) * re[i];
        for (int j = 0; j < n; j++) {
          sr += a[i * n + j] * re[j];
          si += a[i * n + j] * im[j];
        }
        assertThat(Math.hypot(sr, si)).as("vector %d", k).isLessThanOrEqualTo(bound * n * norm);
      }
    }
    return eigen;
  }

  @MethodSource("sizesAndSeeds")
  @ParameterizedTest
  void valuesAreThoseOfAnotherLibrary(int n, long seed) {
    double[] a = matrix(n, seed);
    double[][] rows = new double[n][];
    for (int i = 0; i < n; i++) {
      rows[i] = Arrays.copyOfRange(a, i * n, i * n + n);
    }
    EigenDecomposition other = new EigenDecomposition(new Array2DRowRealMatrix(rows));
    Eigenvalues eigen = new Eigenvalues(n, a);
    boolean[] taken = new boolean[n];
    for (int k = 0; k < n; k++) {
      int nearest = -1;
      double distance = Double.MAX_VALUE;
      for (int j = 0; j < n; j++) {
        double d =
            Math.hypot(
                eigen.real(k) - other.getRealEigenvalue(j),
                eigen.imaginary(k) - other.getImagEigenvalue(j));
        if (!taken[j] && d < distance) {
          nearest = j;
          distance = d;
        }
      }
      taken[nearest] = true;
      // conditions of random matrices of this size stay below 1e4
      assertThat(distance).isLessThan(1e-10);
    }
  }

  /** A chain of masses and springs: ω_k = 2 √(k/m) sin(kπ / (2 (n + 1))). */
  @ValueSource(ints = {1, 2, 5, 20})
  @ParameterizedTest
  void chainOfSpringsHasItsFrequencies(int n) {
    int size = 2 * n;
    double k = 1e6;
    double[] a = new double[size * size];
    for (int i = 0; i < n; i++) {
      a[i * size + n + i] = 1;
      a[(n + i) * size + i] = -2 * k;
      if (i > 0) {
        a[(n + i) * size + i - 1] = k;
        a[(n + i - 1) * size + i] = k;
      }
    }
    Eigenvalues eigen = assertResidual(size, a, 1e-13);
    for (int mode = 1; mode <= n; mode++) {
      double omega = 2 * Math.sqrt(k) * Math.sin(mode * Math.PI / (2 * (n + 1)));
      int at = 2 * (mode - 1);
      assertThat(eigen.imaginary(at)).isCloseTo(omega, within(1e-12 * 2 * Math.sqrt(k)));
      assertThat(eigen.imaginary(at + 1)).isEqualTo(-eigen.imaginary(at));
      assertThat(eigen.real(at)).isCloseTo(0, within(1e-12 * 2 * Math.sqrt(k)));
    }
  }

  /** Two equal oscillators side by side: double pairs with independent vectors. */
  @Test
  void equalPairsKeepIndependentVectors() {
    double[] a = {
      0, 1, 0, 0,
      -4, 0, 0, 0,
      0, 0, 0, 1,
      0, 0, -4, 0
    };
    Eigenvalues eigen = assertResidual(4, a, 1e-14);
    double[][] re = new double[2][4];
    double[][] im = new double[2][4];
    eigen.vector(0, re[0], im[0]);
    eigen.vector(2, re[1], im[1]);
    assertThat(eigen.imaginary(0)).isCloseTo(2, within(1e-14));
    assertThat(eigen.imaginary(2)).isCloseTo(2, within(1e-14));
    double cross = 0;
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 4; j++) {
        double minorR =
            re[0][i] * re[1][j] - im[0][i] * im[1][j] - re[0][j] * re[1][i] + im[0][j] * im[1][i];
        cross = Math.max(cross, Math.abs(minorR));
      }
    }
    assertThat(cross).isGreaterThan(0.1);
  }

  /** Scaled by 1e-8 … 1e8 a similar matrix keeps its small eigenvalues. */
  @Test
  void badScalingCostsNoDigits() {
    int n = 5;
    double[] a = matrix(n, 7);
    Eigenvalues plain = new Eigenvalues(n, a);
    double[] scaled = a.clone();
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        scaled[i * n + j] *= Math.pow(10, 4.0 * (i - j));
      }
    }
    Eigenvalues similar = new Eigenvalues(n, scaled);
    for (int k = 0; k < n; k++) {
      assertThat(similar.real(k)).isCloseTo(plain.real(k), within(1e-13));
      assertThat(similar.imaginary(k)).isCloseTo(plain.imaginary(k), within(1e-13));
    }
  }

  @Test
  void zeroAndDefectiveMatricesAreNoTrouble() {
    assertResidual(3, new double[9], 1e-14);
    Eigenvalues jordan = new Eigenvalues(2, new double[] {0, 1, 0, 0});
    assertThat(jordan.converged()).isTrue();
    assertThat(jordan.real(0)).isZero();
    assertThat(jordan.real(1)).isZero();
    assertThat(new Eigenvalues(0, new double[0]).converged()).isTrue();
  }
}
