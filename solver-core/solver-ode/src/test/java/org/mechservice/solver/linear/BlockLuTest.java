package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** One block does what every solver does; several do the same as a dense matrix with zeros. */
class BlockLuTest extends LinearSolverContract {
  @Override
  protected LinearSolver create(int n) {
    return new BlockLu(new BlockLayout(n, Math.max(1, n)), DenseLu::new);
  }

  @ParameterizedTest
  @CsvSource({"6, 2", "7, 3", "5, 4", "9, 1", "12, 12"})
  void blocksAreSolvedAsIfTheyWereDense(int n, int size) {
    Random random = new Random(31);
    BlockLayout layout = new BlockLayout(n, size);
    LinearSolver blocks = new BlockLu(layout, DenseLu::new);
    LinearSolver dense = new DenseLu(n);
    double[] packed = new double[layout.length()];
    double[] full = new double[n * n];
    for (int j = 0; j < n; j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
        full[i * n + j] = random.nextGaussian();
        packed[layout.index(i, j)] = full[i * n + j];
      }
    }
    assertThat(blocks.factor(packed)).isEqualTo(dense.factor(full));
    double[] x = random.doubles(n).toArray();
    double[] expected = x.clone();
    blocks.solve(x);
    dense.solve(expected);
    assertThat(x).containsExactly(expected, within(1e-11));
    assertThat(blocks.reciprocalCondition()).isBetween(dense.reciprocalCondition() / 3, 1.0);
  }

  @Test
  void everyElementHasAPlaceOfItsOwn() {
    BlockLayout layout = new BlockLayout(8, 3);
    boolean[] taken = new boolean[layout.length()];
    for (int j = 0; j < 8; j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
        assertThat(taken[layout.index(i, j)]).isFalse();
        taken[layout.index(i, j)] = true;
      }
    }
    assertThat(taken).doesNotContain(false).hasSize(9 + 9 + 4);
    assertThat(layout.blocks()).isEqualTo(3);
  }

  @Test
  void firstSingularColumnIsTold() {
    LinearSolver solver = new BlockLu(new BlockLayout(4, 2), DenseLu::new);
    assertThat(solver.factor(new double[] {1, 0, 0, 1, 1, 1, 1, 1})).isEqualTo(3);
  }

  @Test
  void blocksWithoutRowsAreRefused() {
    assertThatIllegalArgumentException().isThrownBy(() -> new BlockLayout(4, 0));
  }
}
