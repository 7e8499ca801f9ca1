package org.mechservice.client.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ReportJsonTest {
  private static Map<String, Object> read(String number) {
    return ReportJson.parse("{\"x\":" + number + "}");
  }

  @ParameterizedTest
  @ValueSource(longs = {0, 1, -3, 402, 999_999_999_999_999_999L})
  void countsStayCounts(long count) {
    assertThat(read(Long.toString(count))).containsEntry("x", count);
  }

  /** However large: an energy of 1e8 J is no count. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 2, -0.5, 1e7, 3.455386405474265e15, 1e22, 1e300, 4.9e-324})
  void measuresStayMeasures(double measure) {
    assertThat(read(Double.toString(measure))).containsEntry("x", measure);
  }
}
