package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.run.RunSettings;

class OutputTimesTest {
  @Test
  void startAndEndAreRows() {
    assertThat(times(0, 3, 1)).containsExactly(0, 1, 2, 3);
  }

  @Test
  void endIsARowWhereTheStepDoesNotDivideTheInterval() {
    assertThat(times(0, 1, 0.4)).containsExactly(0, 0.4, 0.8, 1);
  }

  @Test
  void decimalTimesAreTheNearestNumbersToTheDecimals() {
    double[] times = times(0, 3, 0.01);
    assertThat(times).hasSize(301);
    for (int i = 0; i < times.length; i++) {
      assertThat(times[i]).isEqualTo(Double.parseDouble(i + "e-2"));
    }
  }

  @Test
  void zeroLengthIntervalIsOneRow() {
    assertThat(times(2, 2, 0.1)).containsExactly(2);
  }

  @Test
  void stepLongerThanTheIntervalLeavesStartAndEnd() {
    assertThat(times(1, 1.5, 10)).containsExactly(1, 1.5);
  }

  @Test
  void roundingOfTheIntervalAddsNoRow() {
    assertThat(times(0, 0.3, 0.1)).containsExactly(0, 0.1, 0.2, 0.3);
  }

  private static double[] times(double start, double end, double step) {
    OutputTimes times = new OutputTimes(new RunSettings(start, end, step, "DE", 1e-6, 1e-6));
    return LongStream.range(0, times.count()).mapToDouble(times::time).toArray();
  }
}
