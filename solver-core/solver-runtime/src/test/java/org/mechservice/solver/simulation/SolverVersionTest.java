package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SolverVersionTest {
  @Test
  void isTheVersionOfTheBuild() {
    assertThat(SolverVersion.CURRENT).isEqualTo(System.getProperty("project.version"));
  }
}
