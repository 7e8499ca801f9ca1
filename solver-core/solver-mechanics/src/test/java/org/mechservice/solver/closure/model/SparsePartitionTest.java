package org.mechservice.solver.closure.model;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.linear.SparseMatrix;

/** One equation in three unknowns; the choice is that of its largest element. */
class SparsePartitionTest {
  private static final double BETTER = 2;

  private final SparseMatrix row = SparseMatrix.of(new int[][] {{0, 1, 2}}, 3);
  private final SparsePartition partition = new SparsePartition(row, 3, 1);

  @BeforeEach
  void chooseTheFirstUnknown() {
    partition.scale(new double[] {1}, new double[] {1, 1, 1});
    assertThat(partition.choose(elements(4, 1, 1))).isTrue();
    assertThat(partition.dependent).containsExactly(0);
  }

  private SparseMatrix elements(double... elements) {
    System.arraycopy(elements, 0, row.value, 0, 3);
    return row;
  }

  @Test
  void choiceStaysWhileItsPivotKeepsItsSize() {
    assertThat(partition.renew(elements(3, 9, 1), BETTER)).isFalse();
    assertThat(partition.dependent).containsExactly(0);
    assertThat(partition.bestPivot()).isEqualTo(3);
  }

  @Test
  void choiceWhosePivotHasFallenGivesWayToAMuchLargerOne() {
    assertThat(partition.renew(elements(2, 5, 1), BETTER)).isTrue();
    assertThat(partition.dependent).containsExactly(1);
    assertThat(partition.bestPivot()).isEqualTo(5);
  }

  @Test
  void choiceWhosePivotHasFallenStaysIfOthersAreHardlyLarger() {
    assertThat(partition.renew(elements(2, 3, 1), BETTER)).isFalse();
    assertThat(partition.dependent).containsExactly(0);
    assertThat(partition.bestPivot()).isEqualTo(3);
    // From now on the choice is measured by what it was when compared, not by the best there was.
    assertThat(partition.renew(elements(1.9, 9, 1), BETTER)).isFalse();
  }

  /** A tenth of the largest pivot so far and less: no comparison is left out. */
  @Test
  void choiceNearASingularPositionIsComparedAtEveryState() {
    assertThat(partition.renew(elements(0.3, 0.2, 0.1), BETTER)).isFalse();
    assertThat(partition.renew(elements(0.3, 0.9, 0.1), BETTER)).isTrue();
    assertThat(partition.dependent).containsExactly(1);
  }

  @Test
  void restoredPartitionComparesWhenTheSavedOneWouldHave() {
    double[] state = new double[partition.stateLength()];
    partition.save(state, 0);
    SparsePartition restored = new SparsePartition(row, 3, 1);
    restored.scale(new double[] {1}, new double[] {1, 1, 1});
    restored.restore(state, 0);
    assertThat(restored.renew(elements(3, 9, 1), BETTER)).isFalse();
    assertThat(restored.renew(elements(2, 9, 1), BETTER)).isTrue();
  }
}
