package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.linear.spectrum.Eigenvalues;

class SymmetricFrontsTest {
  static IntStream seeds() {
    return IntStream.range(0, 60);
  }

  /** A random pattern in random groups; every third has equations, which have no diagonal. */
  private static final class Problem {
    final Random random;
    final int n;
    final int equations;
    final int[][] groups;
    final int[] row;
    final int[] column;
    final double[] value;
    final double[] dense;

    Problem(int seed) {
      random = new Random(seed);
      n = 1 + random.nextInt(40);
      equations = seed % 3 == 0 ? n / 3 : 0;
      int count = 1 + random.nextInt(n);
      int[] turn = random.ints(n, 0, count).toArray();
      groups = new int[count][];
      for (int g = 0; g < count; g++) {
        int present = g;
        groups[g] = IntStream.range(0, n).filter(i -> turn[i] == present).toArray();
      }
      int free = n - equations;
      int elements = 4 * n;
      row = new int[n + elements];
      column = new int[n + elements];
      value = new double[n + elements];
      for (int e = 0; e < row.length; e++) {
        row[e] = e < n ? e : random.nextInt(n);
        column[e] = e < n ? e : random.nextInt(free);
        boolean ofEquations = e < n && e >= free;
        double size = seed % 5 == 0 ? Math.pow(10, random.nextInt(9) - 4) : 1;
        value[e] = ofEquations ? 0 : size * random.nextGaussian();
      }
      for (int e = 0; e < equations; e++) { // makes the equations independent
        row[n + e] = free + e;
        column[n + e] = e;
        value[n + e] = 3;
      }
      dense = new double[n * n];
      for (int e = 0; e < row.length; e++) {
        dense[row[e] * n + column[e]] += value[e];
        if (row[e] != column[e]) {
          dense[column[e] * n + row[e]] += value[e];
        }
      }
    }
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void countsTheNegativeEigenvaluesAndSolves(int seed) {
    Problem problem = new Problem(seed);
    int n = problem.n;
    SymmetricFronts fronts =
        new SymmetricFronts(
            n, problem.groups, new int[problem.groups.length], problem.row, problem.column);
    assertThat(fronts.factor(problem.value)).isTrue();
    Eigenvalues eigen = new Eigenvalues(n, problem.dense.clone());
    int negative = (int) IntStream.range(0, n).filter(i -> eigen.real(i) < 0).count();
    assertThat(fronts.negative()).isEqualTo(negative);
    double[] x = problem.random.doubles(n, -1, 1).toArray();
    double[] b = new double[n];
    double norm = 0;
    for (int i = 0; i < n; i++) {
      double sum = 0;
      for (int j = 0; j < n; j++) {
        b[i] += problem.dense[i * n + j] * x[j];
        sum += Math.abs(problem.dense[i * n + j]);
      }
      norm = Math.max(norm, sum);
    }
    double[] solution = b.clone();
    fronts.solve(solution);
    double size = IntStream.range(0, n).mapToDouble(i -> Math.abs(solution[i])).max().orElse(0);
    for (int i = 0; i < n; i++) {
      double left = b[i];
      for (int j = 0; j < n; j++) {
        left -= problem.dense[i * n + j] * solution[j];
      }
      // backward error: rounding of n terms, grown by pivots of a tenth of their columns
      assertThat(left).isCloseTo(0, offset(1e-12 * norm * Math.max(1, size)));
    }
  }

  /** x xᵀ and a row of zeros: all but one eigenvalue are zero, which rounding must not hide. */
  @ParameterizedTest
  @MethodSource("seeds")
  void tellsWhatIsRounding(int seed) {
    Random random = new Random(seed);
    int n = 2 + random.nextInt(6);
    double[] x = random.doubles(n, 0.5, 1).toArray();
    int[] row = new int[n * (n + 1) / 2];
    int[] column = new int[row.length];
    double[] value = new double[row.length];
    int next = 0;
    for (int i = 0; i < n; i++) {
      for (int j = 0; j <= i; j++) {
        row[next] = i;
        column[next] = j;
        value[next++] = -x[i] * x[j];
      }
    }
    int[][] groups = IntStream.rangeClosed(0, n).mapToObj(i -> new int[] {i}).toArray(int[][]::new);
    SymmetricFronts fronts = new SymmetricFronts(n + 1, groups, new int[n + 1], row, column);
    assertThat(fronts.factor(value)).isFalse();
    assertThat(fronts.rounding()).isEqualTo(n);
    assertThat(fronts.negative()).isEqualTo(1);
  }
}
