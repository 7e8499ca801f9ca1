package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;

class PivotedEliminationTest {
  @Test
  void largestElementIsTheFirstPivot() {
    PivotedElimination elimination = new PivotedElimination(2, 3);
    assertThat(elimination.eliminate(new double[] {1, 2, 3, 4, -9, 5}, 2)).isEqualTo(2);
    assertThat(elimination.row(0)).isEqualTo(1);
    assertThat(elimination.column(0)).isEqualTo(1);
    assertThat(elimination.pivot(0)).isEqualTo(9);
  }

  @Test
  void rowsThatDependOnOthersGiveNoPivot() {
    // Row 2 = row 0 − row 1, in numbers without rounding.
    double[] a = {1, 2, 3, 4, 0, 1, 1, 0, 1, 1, 2, 4};
    PivotedElimination elimination = new PivotedElimination(3, 4);
    assertThat(elimination.eliminate(a, 3)).isEqualTo(2);
  }

  @Test
  void rowsAndColumnsArePermutations() {
    int m = 6;
    int n = 10;
    PivotedElimination elimination = new PivotedElimination(m, n);
    elimination.eliminate(new Random(3).doubles((long) m * n, -1, 1).toArray(), m);
    boolean[] row = new boolean[m];
    boolean[] column = new boolean[n];
    for (int i = 0; i < m; i++) {
      row[elimination.row(i)] = true;
    }
    for (int j = 0; j < n; j++) {
      column[elimination.column(j)] = true;
    }
    assertThat(row).doesNotContain(false);
    assertThat(column).doesNotContain(false);
  }

  @Test
  void stopsWhenEnoughAreFound() {
    PivotedElimination elimination = new PivotedElimination(3, 3);
    assertThat(elimination.eliminate(new double[] {1, 0, 0, 0, 2, 0, 0, 0, 3}, 2)).isEqualTo(2);
    assertThat(elimination.lastOverFirst()).isEqualTo(2.0 / 3);
  }
}
