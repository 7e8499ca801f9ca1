package org.mechservice.report.measure;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;

class TimeSharesTest {
  /** A model whose capability comes from a class above it. */
  private abstract static class Explicit implements ExplicitModel {}

  private abstract static class Generated extends Explicit implements Comparable<Generated> {}

  @Test
  void watchedModelKeepsWhatTheModelCan() {
    assertThat(TimeShares.interfaces(Generated.class))
        .contains(ExplicitModel.class, Model.class)
        .doesNotContain(Comparable.class);
    assertThat(TimeShares.interfaces(ModelParts.class)).contains(Model.class);
  }
}
