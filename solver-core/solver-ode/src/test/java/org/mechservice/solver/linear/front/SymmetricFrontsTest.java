package org.mechservice.solver.linear.front;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
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

  /** Elements given one by one: row, column and value. */
  private static final class Listed {
    final int[] row;
    final int[] column;
    final double[] value;

    Listed(double[]... elements) {
      row = Arrays.stream(elements).mapToInt(e -> (int) e[0]).toArray();
      column = Arrays.stream(elements).mapToInt(e -> (int) e[1]).toArray();
      value = Arrays.stream(elements).mapToDouble(e -> e[2]).toArray();
    }

    SymmetricFronts fronts(int[][] groups, int... paired) {
      int n = Arrays.stream(groups).mapToInt(group -> group.length).sum();
      return new SymmetricFronts(n, groups, Arrays.copyOf(paired, groups.length), row, column);
    }
  }

  private static double[] e(int row, int column, double value) {
    return new double[] {row, column, value};
  }

  /** Both rows of a given pivot count: none, one or two of its eigenvalues are negative. */
  @ParameterizedTest
  @CsvSource({"2, 1, 3, 0", "-2, 1, -3, 2", "2, 3, 1, 1", "-2, 3, -1, 1", "0, 1, -2, 1"})
  void countsBothEigenvaluesOfAGivenPivot(double a, double cross, double b, int negative) {
    Listed listed = new Listed(e(0, 0, a), e(1, 0, cross), e(1, 1, b));
    SymmetricFronts fronts = listed.fronts(new int[][] {{0, 1}}, 2);
    assertThat(fronts.factor(listed.value)).isTrue();
    assertThat(fronts.negative()).isEqualTo(negative);
    double[] x = {a + 2 * cross, cross + 2 * b};
    fronts.solve(x);
    assertThat(x).containsExactly(new double[] {1, 2}, offset(1e-14));
  }

  /** [0, 0, 1; 0, 1, 0; 1, 0, 0]: the first two rows are given as a pivot, but not coupled. */
  @Test
  void searchesWhereTheRowsOfAGivenPivotAreNotCoupled() {
    Listed listed = new Listed(e(1, 0, 0), e(1, 1, 1), e(2, 0, 1));
    SymmetricFronts fronts = listed.fronts(new int[][] {{0, 1}, {2}}, 2);
    assertThat(fronts.factor(listed.value)).isTrue();
    assertThat(fronts.negative()).isEqualTo(1);
    double[] x = {3, 2, 1};
    fronts.solve(x);
    assertThat(x).containsExactly(1, 2, 3);
  }

  /** [1, 1, 1; 1, 1, 0; 1, 0, 0]: the first two rows are given as a pivot, which is singular. */
  @Test
  void searchesWhereAGivenPivotIsSingular() {
    Listed listed = new Listed(e(0, 0, 1), e(1, 0, 1), e(1, 1, 1), e(2, 0, 1));
    SymmetricFronts fronts = listed.fronts(new int[][] {{0, 1}, {2}}, 2);
    assertThat(fronts.factor(listed.value)).isTrue();
    assertThat(fronts.negative()).isEqualTo(1);
    double[] x = {6, 3, 1};
    fronts.solve(x);
    assertThat(x).containsExactly(1, 2, 3);
  }

  /**
   * [0, s; s, 0] of many groups, each coupled with the last one by 1. As pivots s = 1e-3 are too
   * small for a search, which leaves their rows, and too many of them end it; given, they are
   * taken.
   */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void takesGivenPivotsWithoutASearch(boolean given) {
    int pairs = 60;
    int last = 2 * pairs;
    int[][] groups = new int[pairs + 1][];
    int[] paired = new int[pairs];
    List<double[]> elements = new ArrayList<>(List.of(e(last, last, 1)));
    for (int p = 0; p < pairs; p++) {
      groups[p] = new int[] {2 * p, 2 * p + 1};
      paired[p] = given ? 2 : 0;
      elements.add(e(2 * p + 1, 2 * p, 1e-3));
      elements.add(e(last, 2 * p, 1));
      elements.add(e(last, 2 * p + 1, 1));
    }
    groups[pairs] = new int[] {last};
    Listed listed = new Listed(elements.toArray(double[][]::new));
    SymmetricFronts fronts = listed.fronts(groups, paired);

    assertThat(fronts.factor(listed.value)).isEqualTo(given);
    assertThat(fronts.isAbandoned()).isEqualTo(!given);
    if (given) { // one of each pair, and 1 − 2 pairs / s
      assertThat(fronts.negative()).isEqualTo(pairs + 1);
    }
  }

  /** [ε, 1; 1, 1] with each row in a group: ε as a pivot would cost all digits of the 1 below. */
  @Test
  void leavesASmallPivotToALaterGroup() {
    double small = 1e-17;
    Listed listed = new Listed(e(0, 0, small), e(1, 0, 1), e(1, 1, 1));
    SymmetricFronts fronts = listed.fronts(new int[][] {{0}, {1}});
    assertThat(fronts.factor(listed.value)).isTrue();
    assertThat(fronts.negative()).isEqualTo(1);
    double[] x = {small + 2, 1 + 2};
    fronts.solve(x);
    assertThat(x).containsExactly(new double[] {1, 2}, offset(1e-14));
  }

  /** Rows of 0.1 + 0.2 − 0.3, coupled with the last one by 0: more than may be left to it. */
  @Test
  void doesNotLeaveRowsThatAreRounding() {
    int rows = 150;
    List<double[]> elements = new ArrayList<>(List.of(e(rows, rows, 1)));
    for (int i = 0; i < rows; i++) {
      elements.addAll(List.of(e(i, i, 0.1), e(i, i, 0.2), e(i, i, -0.3), e(rows, i, 0)));
    }
    int[][] groups =
        IntStream.rangeClosed(0, rows).mapToObj(i -> new int[] {i}).toArray(int[][]::new);
    Listed listed = new Listed(elements.toArray(double[][]::new));
    SymmetricFronts fronts = listed.fronts(groups);
    assertThat(fronts.factor(listed.value)).isFalse();
    assertThat(fronts.isAbandoned()).isFalse();
    assertThat(fronts.rounding()).isEqualTo(rows);
  }

  /** [a, 4e-14; 4e-14, −1e-12] with a = 1 − (1 + 5e-15), which may as well be 0. */
  @Test
  void takesNoPivotOfOneRowThatIsRounding() {
    Listed listed = new Listed(e(0, 0, 1), e(0, 0, -1 - 5e-15), e(1, 0, 4e-14), e(1, 1, -1e-12));
    SymmetricFronts fronts = listed.fronts(new int[][] {{0}, {1}});
    assertThat(fronts.factor(listed.value)).isFalse();
    assertThat(fronts.rounding()).isEqualTo(1);
    assertThat(fronts.negative()).isEqualTo(1);
  }

  /** [1 − 1, c; c, 1 − 1] with c below the rounding of 1 − 1, and little beside it. */
  @Test
  void takesNoPivotOfTwoRowsThatIsRounding() {
    Listed listed =
        new Listed(
            e(0, 0, 1),
            e(0, 0, -1),
            e(1, 1, 1),
            e(1, 1, -1),
            e(1, 0, 2e-14),
            e(2, 0, 4e-14),
            e(2, 1, 4e-14),
            e(2, 2, 1));
    SymmetricFronts fronts = listed.fronts(new int[][] {{0, 1}, {2}});
    assertThat(fronts.factor(listed.value)).isFalse();
    assertThat(fronts.rounding()).isEqualTo(2);
    assertThat(fronts.negative()).isZero();
  }

  /** 0 − 1²/3 + 0.6²/1.08 = 0 but for rounding, which has no size of its own in the last row. */
  @Test
  void knowsWhatPivotsOfOneRowHaveSubtracted() {
    Listed listed = new Listed(e(0, 0, 3), e(1, 1, -1.08), e(2, 0, 1), e(2, 1, 0.6));
    assertThat(0.6 / 1.08 * 0.6 - 1.0 / 3).isNotZero();
    SymmetricFronts fronts = listed.fronts(new int[][] {{0}, {1}, {2}});
    assertThat(fronts.factor(listed.value)).isFalse();
    assertThat(fronts.rounding()).isEqualTo(1);
    assertThat(fronts.negative()).isEqualTo(1);
  }

  /** 0 − 2 · 0.7 · 0.1 / 1 + 2 · 0.3 · 0.7 / 3 = 0 but for rounding. */
  @Test
  void knowsWhatPivotsOfTwoRowsHaveSubtracted() {
    Listed listed =
        new Listed(e(1, 0, 1), e(4, 0, 0.7), e(4, 1, 0.1), e(3, 2, -3), e(4, 2, 0.3), e(4, 3, 0.7));
    assertThat(3 * 0.7 / 9 * 0.3 + 3 * 0.3 / 9 * 0.7 - 2 * 0.7 * 0.1).isNotZero();
    SymmetricFronts fronts = listed.fronts(new int[][] {{0, 1}, {2, 3}, {4}});
    assertThat(fronts.factor(listed.value)).isFalse();
    assertThat(fronts.rounding()).isEqualTo(1);
    assertThat(fronts.negative()).isEqualTo(2);
  }

  @Test
  void isNotRegularWithWhatIsNotANumber() {
    Listed listed = new Listed(e(0, 0, Double.NaN), e(1, 0, 1), e(1, 1, 1));
    assertThat(listed.fronts(new int[][] {{0}, {1}}).factor(listed.value)).isFalse();
  }

  /** The second of three groups has a negative eigenvalue more than may be. */
  @Test
  void stopsWhereMoreEigenvaluesAreNegativeThanMayBe() {
    Listed listed = new Listed(e(0, 0, 1), e(1, 1, -1), e(2, 2, -1));
    SymmetricFronts fronts = listed.fronts(new int[][] {{0}, {1}, {2}});
    assertThat(fronts.factor(listed.value, 1)).isTrue();
    assertThat(fronts.isAbandoned()).isFalse();
    assertThat(fronts.negative()).isEqualTo(2);

    assertThat(fronts.factor(listed.value, 0)).isFalse();
    assertThat(fronts.isAbandoned()).isTrue();
    assertThat(fronts.negative()).isEqualTo(1);
  }
}
