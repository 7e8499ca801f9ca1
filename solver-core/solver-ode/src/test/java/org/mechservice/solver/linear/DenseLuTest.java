package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;

class DenseLuTest extends LuFactorsContract {
  @Override
  protected LinearSolver create(int n) {
    return new DenseLu(n);
  }

  @Test
  void elementsAreStoredRowAfterRow() {
    DenseLayout layout = new DenseLayout(3);
    assertThat(layout.index(1, 2)).isEqualTo(5);
    assertThat(layout.length()).isEqualTo(9);
    assertThat(layout.columnDistance()).isEqualTo(3);
  }

  @Test
  void negativeDimensionIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new DenseLu(-1))
        .withMessageContaining("dimension of a matrix is -1");
  }
}
