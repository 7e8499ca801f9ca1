package org.mechservice.solver.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;

class ReportTextTest {
  private final Map<String, Object> report = new LinkedHashMap<>();

  @Test
  void alignsEntriesAndGivesUnits() {
    report.put("scene", "Pendulum");
    report.put("rejectedSteps", 12L);
    report.put("energyDrift", 1.23456e-7);
    report.put("t1c", 0.0123456);
    report.put("realTimeFactor", 12345.678);
    assertThat(ReportText.format(report))
        .isEqualTo(
            """
            scene             Pendulum
            rejected steps    12
            energy drift      1.235e-7 J
            t1c               0.01235 s
            real time factor  12346
            """);
  }

  @Test
  void jsonKeepsEveryDigitAndEscapesText() {
    report.put("name", "a\"\\\n\u00e9");
    report.put("x", 0.1 + 0.2);
    report.put("n", 3L);
    report.put("bad", Double.NaN);
    assertThat(JsonText.write(report))
        .isEqualTo(
            "{\n  \"name\": \"a\\\"\\\\\\u000a\u00e9\",\n  \"x\": 0.30000000000000004,\n  \"n\": 3,\n"
                + "  \"bad\": null\n}");
  }

  @Test
  void jsonRefusesWhatItHasNoFormFor() {
    report.put("x", new Object());
    assertThatThrownBy(() -> JsonText.write(report)).isInstanceOf(IllegalArgumentException.class);
  }
}
