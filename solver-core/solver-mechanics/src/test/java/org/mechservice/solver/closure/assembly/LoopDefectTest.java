package org.mechservice.solver.closure.assembly;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is advised where loops end a run. */
class LoopDefectTest {
  @ParameterizedTest
  @CsvSource({
    "DSR, false, RR-JF with ode15sR",
    "DSR, true, RR-JF with ode15sR",
    "RR, false, RR-JF",
    "RR, true, DSR with ode113",
    "RR-JF, false, DSR with penalty closure and ode113",
    "RR-JF, true, DSR with ode113"
  })
  void anotherMethodThanTheOneThatRunsIsAdvised(String running, boolean penalty, String other) {
    String advice = LoopDefect.singular("c", 1e-3, running, penalty).advice();
    assertThat(advice).contains("or end the run before; " + other + ", or a looser tolerance");
    String advised = advice.substring(0, advice.indexOf(", or a looser tolerance"));
    assertThat(advised).doesNotContainPattern("\\b" + running + "(?!-JF)\\b");
    if (penalty) {
      assertThat(advised).doesNotContain("penalty closure");
    }
  }
}
