package org.mechservice.sim.service;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class WarmUpTest {
  @Test
  void modelThatWarmsAHostUpIsBuiltAndPackedWithoutWarnings() throws Exception {
    assertThat(WarmUp.run()).isZero();
  }
}
