package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;

class SparseMatrixTest {
  @Test
  void columnsAscendAndAreBelowTheirNumber() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> SparseMatrix.of(new int[][] {{1, 1}}, 3))
        .withMessage("column 1 of 3 after 1");
    assertThatIllegalArgumentException().isThrownBy(() -> SparseMatrix.of(new int[][] {{3}}, 3));
  }

  @Test
  void holdsWhatIsOfThePatternAndNothingElse() {
    SparseMatrix matrix = SparseMatrix.of(new int[][] {{0, 2}, {}, {1}}, 3);
    matrix.setRow(0, new double[] {1, 2, 3}, 0);
    matrix.setRow(2, new double[] {9, 4, 5, 6}, 1);
    assertThat(matrix.get(0, 2)).isEqualTo(3);
    assertThat(matrix.get(0, 1)).isZero();
    assertThat(matrix.get(2, 1)).isEqualTo(5);
    double[] dense = new double[6];
    matrix.toDense(dense, 2);
    assertThat(dense).containsExactly(1, 0, 0, 0, 0, 5);
    assertThat(matrix.product(0, new double[] {10, 20, 30}, 0)).isEqualTo(100);
    double[] sum = new double[3];
    matrix.addRow(0, 2, sum, 0);
    assertThat(sum).containsExactly(2, 0, 6);
    SparseMatrix other = matrix.sameShape();
    other.copy(matrix);
    matrix.clear();
    assertThat(matrix.get(0, 0)).isZero();
    assertThat(other.get(0, 0)).isEqualTo(1);
  }
}
