package org.mechservice.solver.dynamics.tree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.linear.DenseLayout;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.FactorsContract;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.MatrixLayout;

/**
 * Along a chain, where every velocity is coupled with every other, it does what every solver does;
 * along other trees the same as a dense one.
 */
class TreeLuTest extends FactorsContract {
  private static final int[] NO_PAIRS = {};

  /** A chain's velocities, numbered in the order they are eliminated in. */
  private static final class OnChain implements LinearSolver {
    private final int n;
    private final TreeSquare square;
    private final TreeLu lu;

    OnChain(int n) {
      this.n = n;
      int[] velocityAt = IntStream.range(0, n).map(place -> n - 1 - place).toArray();
      int[] parent = IntStream.range(0, n).map(place -> place - 1).toArray();
      TreePattern pattern = new TreePattern(velocityAt, parent, NO_PAIRS);
      square = new TreeSquare(pattern);
      lu = new TreeLu(pattern);
    }

    @Override
    public MatrixLayout layout() {
      return new DenseLayout(n);
    }

    @Override
    public int factor(double[] matrix) {
      square.clear();
      for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
          square.add(i, j, matrix[n * i + j]);
        }
      }
      return lu.factor(square);
    }

    @Override
    public void solve(double[] b) {
      lu.solve(b);
    }

    @Override
    public double reciprocalCondition() {
      throw new UnsupportedOperationException("factors along a tree do not tell their condition");
    }
  }

  @Override
  protected LinearSolver create(int n) {
    return new OnChain(n);
  }

  static LongStream seeds() {
    return LongStream.rangeClosed(1, 30);
  }

  /** A tree of 20 velocities in any numbering, with some further elements if asked for. */
  private static TreePattern pattern(Random random, int coupled) {
    int n = 20;
    int[] velocityAt = random.ints(0, n).distinct().limit(n).toArray();
    int[] parent = IntStream.range(0, n).map(place -> random.nextInt(place + 1) - 1).toArray();
    return new TreePattern(velocityAt, parent, random.ints(2L * coupled, 0, n).toArray());
  }

  /** Random elements in the whole pattern, with one size on the diagonal. */
  private static TreeSquare random(TreePattern pattern, Random random, double diagonal) {
    TreeSquare matrix = new TreeSquare(pattern);
    for (int i = 0; i < pattern.size(); i++) {
      matrix.diagonal[i] = diagonal * (1 + random.nextDouble());
    }
    for (int e = 0; e < pattern.elementCount(); e++) {
      matrix.lower[e] = random.nextDouble() - 0.5;
      matrix.upper[e] = random.nextDouble() - 0.5;
    }
    return matrix;
  }

  private static double[] dense(TreeSquare matrix, int n) {
    double[] elements = new double[n * n];
    matrix.toDense(elements);
    return elements;
  }

  private static void assertSolvedAsDense(TreeLu lu, TreeSquare matrix, int n) {
    double[] x = new Random(SEED).doubles(n).toArray();
    double[] expected = x.clone();
    DenseLu full = new DenseLu(n);
    assertThat(lu.factor(matrix)).isEqualTo(full.factor(dense(matrix, n)));
    lu.solve(x);
    full.solve(expected);
    double size = Arrays.stream(expected).map(Math::abs).max().orElse(0);
    // Round-off of either by the condition, which is seldom above 1e4 here.
    double allowed = 100 * Math.ulp(1.0) / full.reciprocalCondition();
    assertThat(x).containsExactly(expected, within(allowed * size));
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void treeIsSolvedAsIfItWereDense(long seed) {
    Random random = new Random(seed);
    TreePattern pattern = pattern(random, 0);
    TreeLu lu = new TreeLu(pattern);
    assertSolvedAsDense(lu, random(pattern, random, 20), pattern.size());
    assertThat(lu.denseFactorizations()).isZero();
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void coupledBranchesAreSolvedAsIfTheyWereDense(long seed) {
    Random random = new Random(seed);
    TreePattern pattern = pattern(random, 4);
    TreeLu lu = new TreeLu(pattern);
    assertSolvedAsDense(lu, random(pattern, random, 20), pattern.size());
    assertThat(lu.denseFactorizations()).isZero();
  }

  /** Every second pivot is 1e-9; beside elements of 1 it would cost nine digits. */
  @ParameterizedTest
  @MethodSource("seeds")
  void pivotsTooSmallAlongTheTreeCostNoDigits(long seed) {
    Random random = new Random(seed);
    TreePattern pattern = pattern(random, 4);
    TreeSquare matrix = random(pattern, random, 1e-9);
    for (int i = 0; i < pattern.size(); i += 2) {
      matrix.diagonal[i] = 20;
    }
    TreeLu lu = new TreeLu(pattern);
    assertSolvedAsDense(lu, matrix, pattern.size());
  }

  @Test
  void matrixWithoutPivotsAlongTheTreeIsFactoredAsADenseOne() {
    TreePattern pattern = pattern(new Random(3), 1);
    TreeSquare matrix = new TreeSquare(pattern);
    int last = pattern.velocityAt[pattern.size - 1];
    int before = pattern.velocityAt[pattern.column[pattern.rowStart[pattern.size] - 1]];
    for (int i = 0; i < pattern.size(); i++) {
      matrix.add(i, i, i == last || i == before ? 0 : 2);
    }
    matrix.add(last, before, 1);
    matrix.add(before, last, 4);
    TreeLu lu = new TreeLu(pattern);
    assertThat(lu.factor(matrix)).isEqualTo(TreeLu.NONSINGULAR);
    assertThat(lu.denseFactorizations()).isEqualTo(1);
    double[] b = new double[pattern.size()];
    b[last] = 3;
    lu.solve(b);
    assertThat(b[before]).isCloseTo(3, within(1e-15));
  }
}
