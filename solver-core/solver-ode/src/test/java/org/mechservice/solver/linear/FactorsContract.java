package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * What factors and solutions are to be for matrices of which no element is structurally zero,
 * whatever they are factored by.
 */
public abstract class FactorsContract {
  protected static final long SEED = 20031;

  /** Returns a solver for n × n matrices. */
  protected abstract LinearSolver create(int n);

  /** An element of a matrix. */
  public interface Element {
    double at(int i, int j);
  }

  protected final double[] matrix(LinearSolver solver, Element element) {
    MatrixLayout layout = solver.layout();
    double[] matrix = new double[layout.length()];
    for (int j = 0; j < layout.dimension(); j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
        matrix[layout.index(i, j)] = element.at(i, j);
      }
    }
    return matrix;
  }

  protected final LinearSolver factored(int n, Element element) {
    LinearSolver solver = create(n);
    assertThat(solver.factor(matrix(solver, element))).isEqualTo(LinearSolver.NONSINGULAR);
    return solver;
  }

  protected static Element random(int n, Random random) {
    double[][] values = new double[n][n];
    for (double[] row : values) {
      Arrays.setAll(row, j -> random.nextGaussian());
    }
    return (i, j) -> values[i][j];
  }

  protected static double[] unit(int n, int i) {
    double[] e = new double[n];
    e[i] = 1;
    return e;
  }

  @Test
  void inverseOfTheMatrixOfSmallerIndicesIsTheSecondDifference() {
    // A_ij = min(i, j) + 1 has det A = 1 and the inverse with 2 (1 in the corner) and −1 beside it.
    int n = 8;
    LinearSolver solver = factored(n, (i, j) -> Math.min(i, j) + 1);
    for (int j = 0; j < n; j++) {
      double[] column = unit(n, j);
      solver.solve(column);
      for (int i = 0; i < n; i++) {
        double expected = i == j ? (i == n - 1 ? 1 : 2) : Math.abs(i - j) == 1 ? -1 : 0;
        assertThat(column[i]).isCloseTo(expected, within(1e-13));
      }
    }
  }

  @Test
  void permutationIsUndoneExactly() {
    int n = 5;
    LinearSolver solver = factored(n, (i, j) -> (i + 2) % n == j ? 1 : 0);
    double[] b = {10, 11, 12, 13, 14};
    solver.solve(b);
    assertThat(b).containsExactly(13, 14, 10, 11, 12);
  }

  @Test
  void smallPivotIsNotDividedBy() {
    // Without interchange 1 − 1e20 would swallow the 1: x_0 = 0 instead of 1.
    double[][] a = {{1e-20, 1}, {1, 1}};
    LinearSolver solver = factored(2, (i, j) -> a[i][j]);
    double[] b = {1, 2};
    solver.solve(b);
    assertThat(b).containsExactly(new double[] {1, 1}, within(1e-15));
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 10, 40})
  void solutionSolvesTheEquations(int n) {
    Random random = new Random(SEED + n);
    Element a = random(n, random);
    LinearSolver solver = factored(n, a);
    double[] b = random.doubles(n).toArray();
    double[] x = b.clone();
    solver.solve(x);
    double size = Arrays.stream(x).map(Math::abs).max().orElse(0);
    for (int i = 0; i < n; i++) {
      double residual = b[i];
      for (int j = 0; j < n; j++) {
        residual -= a.at(i, j) * x[j];
      }
      // Backward error n u ‖A‖ with elements of some 3 and growth of some 10 by elimination.
      assertThat(residual).isCloseTo(0, within(30 * n * n * Math.ulp(1.0) * size));
    }
  }

  @Test
  void solverUsedAgainGivesTheSameBits() {
    int n = 7;
    Element first = random(n, new Random(SEED));
    Element second = random(n, new Random(SEED + 1));
    LinearSolver used = factored(n, first);
    used.factor(matrix(used, second));
    double[] x = unit(n, 3);
    used.solve(x);
    double[] fresh = unit(n, 3);
    factored(n, second).solve(fresh);
    assertThat(x).isEqualTo(fresh);
  }

  @ParameterizedTest
  @ValueSource(ints = {-900, -1, 1, 900})
  void scalingByAPowerOfTwoScalesTheSolutionExactly(int exponent) {
    int n = 6;
    Element a = random(n, new Random(SEED));
    LinearSolver plain = factored(n, a);
    LinearSolver scaled = factored(n, (i, j) -> Math.scalb(a.at(i, j), exponent));
    double[] x = unit(n, 2);
    double[] y = unit(n, 2);
    plain.solve(x);
    scaled.solve(y);
    assertThat(y).isEqualTo(Arrays.stream(x).map(v -> Math.scalb(v, -exponent)).toArray());
  }

  // Singular matrices

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 4})
  void columnOfZerosIsReported(int zero) {
    LinearSolver solver = create(5);
    Element a = random(5, new Random(SEED));
    int pivot = solver.factor(matrix(solver, (i, j) -> j == zero ? 0 : a.at(i, j)));
    assertThat(pivot).isEqualTo(zero);
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY})
  void pivotThatIsNotFiniteIsReported(double value) {
    LinearSolver solver = create(3);
    int pivot = solver.factor(matrix(solver, (i, j) -> i == j ? (i == 1 ? value : 1) : 0));
    assertThat(pivot).isEqualTo(1);
  }

  @Test
  void singularMatrixSolvesNothing() {
    LinearSolver solver = factored(2, (i, j) -> i == j ? 1 : 0);
    solver.factor(matrix(solver, (i, j) -> 1));
    assertThatIllegalStateException().isThrownBy(() -> solver.solve(new double[2]));
  }

  // Edges

  @Test
  void nothingIsSolvedByNothing() {
    LinearSolver solver = create(0);
    assertThat(solver.factor(new double[0])).isEqualTo(LinearSolver.NONSINGULAR);
    solver.solve(new double[0]);
  }

  @Test
  void matrixGivenIsNotModified() {
    LinearSolver solver = create(5);
    double[] a = matrix(solver, random(5, new Random(SEED)));
    double[] copy = a.clone();
    solver.factor(a);
    solver.solve(new double[5]);
    assertThat(a).isEqualTo(copy);
  }

  @Test
  void solutionBeforeTheFactorsIsRefused() {
    assertThatIllegalStateException().isThrownBy(() -> create(2).solve(new double[2]));
  }

  @Test
  void factorsAndSolutionsAllocateNothing() {
    LinearSolver solver = create(10);
    double[] a = matrix(solver, random(10, new Random(SEED)));
    double[] b = new double[10];
    assertThat(
            allocatedBy(
                () -> {
                  solver.factor(a);
                  b[0] = 1;
                  solver.solve(b);
                }))
        .isZero();
  }

  /** Returns the bytes that some calls allocate; the first rounds load classes. */
  static long allocatedBy(Runnable call) {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long allocated = 0;
    for (int round = 0; round < 20; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < 50; i++) {
        call.run();
      }
      allocated = threads.getCurrentThreadAllocatedBytes() - before;
    }
    return allocated;
  }
}
