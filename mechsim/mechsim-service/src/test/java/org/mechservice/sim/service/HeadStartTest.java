package org.mechservice.sim.service;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class HeadStartTest {
  @Test
  void modelOfTheHeadStartIsBuiltWithoutWarnings() throws Exception {
    assertThat(HeadStart.run()).isZero();
  }
}
