package org.mechservice.report.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;

class MeasuredRunTest {
  private static MeasuredRun run(String cause, Map<String, Long> limits) {
    return new MeasuredRun(
        "DSR projection ode113",
        1e-6,
        3,
        cause,
        0.25,
        1000,
        10,
        2,
        20,
        1,
        3,
        new MeasuredRun.Errors(1e-7, 2e-7, 1e-8, 2e-7, 3e-5, 4e-13),
        1e-9,
        limits);
  }

  @Test
  void runIsReadAsItWasWritten() {
    Map<String, Long> limits = new LinkedHashMap<>();
    limits.put("hinge: of the door, left", 12L);
    limits.put("knee", 3L);
    MeasuredRun written = run("N-003 \"hinge\", and more", limits);

    MeasuredRun read = MeasuredRun.parse(written.line());

    assertThat(read.line()).isEqualTo(written.line());
    assertThat(read.limits()).isEqualTo(limits).containsKeys("hinge: of the door, left");
    assertThat(read.errors()).isEqualTo(written.errors());
    assertThat(read.cause()).isEqualTo("N-003 'hinge', and more");
  }

  @Test
  void everyColumnHasItsName() {
    assertThat(run("", Map.of()).line().split(",", -1))
        .hasSameSizeAs(MeasuredRun.HEADER.split(",", -1));
  }

  @Test
  void lineOfAnotherFormatIsRefused() {
    assertThatThrownBy(() -> MeasuredRun.parse("DTR ode113,1e-6"))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
