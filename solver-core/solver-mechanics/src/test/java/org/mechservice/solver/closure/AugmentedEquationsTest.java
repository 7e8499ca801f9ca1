package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.linear.SparseMatrix;

/** Sparse factors solve A x + Jᵀ λ = r, J x + c = 0 as dense ones do, redundant rows included. */
final class AugmentedEquationsTest {
  private static final int UNKNOWNS = 40;
  private static final int ROWS = 9;

  /** Large enough to meet the rows in a few corrections; as the models choose by default. */
  private static final double STIFFNESS = 1e7;

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void sparseAndDenseFactorsGiveTheSameSolution(long seed) {
    Random random = new Random(seed);
    TreePattern pattern = randomTree(random);
    TreeSquare a = randomMatrix(pattern, random);
    double[] units = IntStream.range(0, UNKNOWNS).mapToDouble(i -> i % 3 == 0 ? 0.2 : 1).toArray();
    SparseMatrix rows = randomRows(random);
    DenseAugmentedEquations dense = DenseAugmentedEquations.general(rows, units);
    SparseAugmentedEquations sparse = new SparseAugmentedEquations(rows, units, pattern);
    double[] right = random.doubles(UNKNOWNS, -1, 1).toArray();
    double[] offset = random.doubles(ROWS, -1, 1).toArray();
    offset[ROWS - 1] = offset[0];
    offset[ROWS - 2] = 0;

    assertThat(dense.factor(a, STIFFNESS)).isNegative();
    assertThat(sparse.factor(a, STIFFNESS)).isNegative();
    double[] expected = new double[UNKNOWNS];
    double[] actual = new double[UNKNOWNS];
    dense.solve(right, offset, expected, 0);
    sparse.solve(right, offset, actual, 0);

    double largest = Arrays.stream(expected).map(Math::abs).max().orElseThrow();
    for (int i = 0; i < UNKNOWNS; i++) {
      // the dense corrections lose the digits of the penalty and stop at 1e-11 of the rows' size
      assertThat(actual[i]).isCloseTo(expected[i], within(1e-8 * largest));
    }
    for (int row = 0; row < ROWS; row++) {
      assertThat(rows.product(row, actual, 0) + offset[row]).isCloseTo(0, within(1e-10 * largest));
      assertThat(sparse.multipliers[row])
          .isCloseTo(dense.multipliers[row], within(1e-6 * (1 + Math.abs(dense.multipliers[row]))));
    }
    assertThat(sparse.multipliers[ROWS - 1])
        .as("rows that stand twice share their force")
        .isCloseTo(sparse.multipliers[0], within(1e-6 * (1 + Math.abs(sparse.multipliers[0]))));
  }

  private static TreePattern randomTree(Random random) {
    int[] velocityAt = IntStream.range(0, UNKNOWNS).toArray();
    int[] parent = new int[UNKNOWNS];
    Arrays.setAll(parent, place -> place == 0 ? -1 : random.nextInt(-1, place));
    return new TreePattern(velocityAt, parent, new int[] {7, 3, 20, 11});
  }

  private static TreeSquare randomMatrix(TreePattern pattern, Random random) {
    TreeSquare a = new TreeSquare(pattern);
    Arrays.setAll(a.lower, e -> 0.1 * random.nextGaussian());
    Arrays.setAll(a.upper, e -> 0.1 * random.nextGaussian());
    Arrays.setAll(a.diagonal, place -> 4 + random.nextDouble());
    return a;
  }

  /** Random rows; the last but one is zero and the last repeats the first. */
  private static SparseMatrix randomRows(Random random) {
    int[][] columns = new int[ROWS][];
    for (int row = 0; row < ROWS; row++) {
      columns[row] = random.ints(0, UNKNOWNS).distinct().limit(5).sorted().toArray();
    }
    columns[ROWS - 1] = columns[0];
    SparseMatrix rows = SparseMatrix.of(columns, UNKNOWNS);
    for (int e = 0; e < rows.start[ROWS - 2]; e++) {
      rows.value[e] = random.nextGaussian();
    }
    int last = rows.start[ROWS - 1];
    System.arraycopy(rows.value, 0, rows.value, last, rows.start[1]);
    return rows;
  }
}
