package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Random;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CondensedLuTest extends LinearSolverContract {
  private static final int N = 20;

  @Override
  protected LinearSolver create(int n) {
    return new CondensedLu(n);
  }

  /**
   * I − h J of q' = v, v' = −K q − C v, the unknowns in an order of their own.
   *
   * @param stiffness size of the elements of K
   */
  private static double[][] step(Random random, double h, double stiffness) {
    int[] order = random.ints(0, 2 * N).distinct().limit(2L * N).toArray();
    double[][] a = new double[2 * N][2 * N];
    for (int i = 0; i < N; i++) {
      int q = order[i];
      int v = order[N + i];
      a[q][q] = 1;
      a[q][v] = -h;
      a[v][v] = 1;
      for (int j = 0; j < N; j++) {
        a[v][order[j]] += h * stiffness * (random.nextGaussian() + (i == j ? N : 0));
        a[v][order[N + j]] += h * Math.sqrt(stiffness) * random.nextGaussian();
      }
    }
    return a;
  }

  private static void assertSolved(LinearSolver solver, double[][] a, Random random) {
    int n = a.length;
    assertThat(solver.factor(elements(a))).isEqualTo(LinearSolver.NONSINGULAR);
    double[] b = random.doubles(n, -1, 1).toArray();
    double[] x = b.clone();
    solver.solve(x);
    RealMatrix matrix = new Array2DRowRealMatrix(a);
    double[] expected =
        new LUDecomposition(matrix, 0).getSolver().solve(new ArrayRealVector(b)).toArray();
    double[] product = matrix.operate(x);
    for (int i = 0; i < n; i++) {
      double size = Math.abs(b[i]);
      for (int j = 0; j < n; j++) {
        size += Math.abs(a[i][j] * x[j]);
      }
      // Row by row: no unit of any equation may hide an error of another.
      assertThat(product[i]).isCloseTo(b[i], within(1e3 * n * Math.ulp(1.0) * size));
    }
    double largest = Arrays.stream(expected).map(Math::abs).max().orElse(0);
    double allowed = 1e3 * Math.ulp(largest) / Math.max(1e-9, solver.reciprocalCondition());
    assertThat(x).containsExactly(expected, within(allowed));
  }

  private static double[] elements(double[][] a) {
    return Arrays.stream(a).flatMapToDouble(Arrays::stream).toArray();
  }

  @CsvSource({"1e-3, 1", "1e-5, 1e9", "1e-9, 1e12", "0.5, 1e4", "1, 1", "1e-12, 1e-6", "0, 1"})
  @ParameterizedTest
  void stepOfAMechanismIsSolvedAsAWhole(double h, double stiffness) {
    for (int seed = 1; seed <= 20; seed++) {
      Random random = new Random(seed);
      assertSolved(new CondensedLu(2 * N), step(random, h, stiffness), random);
    }
  }

  /** There −h is larger than the 1 on the diagonal: no row may be divided by that. */
  @Test
  void stepLongerThanASecondIsSolvedAsAWhole() {
    for (int seed = 1; seed <= 20; seed++) {
      Random random = new Random(seed);
      assertSolved(new CondensedLu(2 * N), step(random, 1e5, 1e3), random);
    }
  }

  @Test
  void unknownsThatStandAloneAreSolvedAlone() {
    Random random = new Random(SEED);
    double[][] a = step(random, 1e-3, 1e6);
    for (int i = 0; i < 2 * N; i += 3) {
      for (int j = 0; j < 2 * N; j++) {
        a[i][j] = i == j ? 1e-200 : 0;
        a[j][i] = i == j ? 1e-200 : 0;
      }
    }
    CondensedLu solver = new CondensedLu(2 * N);
    assertThat(solver.factor(elements(a))).isEqualTo(LinearSolver.NONSINGULAR);
    double[] b = random.doubles(2L * N).toArray();
    double[] x = b.clone();
    solver.solve(x);
    for (int i = 0; i < 2 * N; i += 3) {
      assertThat(x[i]).isEqualTo(b[i] / 1e-200);
    }
  }

  /** Each row refers to the next: they cannot all be taken out. */
  @Test
  void chainOfSuchRowsIsSolvedAsAWhole() {
    Random random = new Random(SEED);
    double[][] a = new double[2 * N][2 * N];
    for (int i = 0; i < 2 * N; i++) {
      a[i][i] = 1;
      a[i][(i + 1) % (2 * N)] = random.nextDouble() - 0.5;
    }
    assertSolved(new CondensedLu(2 * N), a, random);
  }

  @Test
  void diagonalMatrixIsSolvedWithoutRest() {
    double[][] a = new double[2 * N][2 * N];
    for (int i = 0; i < 2 * N; i++) {
      a[i][i] = i + 1;
    }
    assertSolved(new CondensedLu(2 * N), a, new Random(SEED));
  }

  /** v_1' depends on nothing and h J has the eigenvalue 1 there: its column has no pivot. */
  @Test
  void velocityWithoutPivotIsNamed() {
    double[][] a = new double[2 * N][2 * N];
    for (int i = 0; i < N; i++) {
      a[i][i] = 1;
      a[i][N + i] = -1e-3;
      for (int j = 0; j < N; j++) {
        a[N + i][N + j] = i == j ? 2 : 1;
      }
    }
    for (int i = 0; i < N; i++) {
      a[N + i][N + 3] = 0;
    }
    assertThat(new CondensedLu(2 * N).factor(elements(a))).isEqualTo(N + 3);
  }

  @Test
  void matricesOfOtherPatternsInBetweenLeaveNoTrace() {
    double[] matrix = elements(step(new Random(1), 1e-3, 1e6));
    double[] full = new Random(2).doubles(4L * N * N).toArray();
    CondensedLu used = new CondensedLu(2 * N);
    used.factor(matrix);
    used.factor(full);
    used.factor(elements(step(new Random(3), 1e-3, 1e6)));
    used.factor(matrix);
    CondensedLu fresh = new CondensedLu(2 * N);
    fresh.factor(matrix);
    double[] x = new Random(4).doubles(2L * N).toArray();
    double[] expected = x.clone();
    used.solve(x);
    fresh.solve(expected);
    assertThat(x).isEqualTo(expected);
  }

  @Test
  void equalPatternsAreFactoredWithoutNewMemory() {
    CondensedLu solver = new CondensedLu(2 * N);
    double[] matrix = elements(step(new Random(1), 1e-3, 1e6));
    double[] x = new double[2 * N];
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long before = 0;
    for (int i = 0; i < 200; i++) {
      before = i == 100 ? threads.getCurrentThreadAllocatedBytes() : before;
      solver.factor(matrix);
      solver.solve(x);
    }
    assertThat(threads.getCurrentThreadAllocatedBytes() - before).isLessThan(1000);
  }
}
