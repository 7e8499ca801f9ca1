package org.mechservice.report.solution;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class ComparableTimesTest {
  private static final double[] TIMES = {0, 1, 2, 3, 4};

  @Test
  void allTimesOfASmoothMotionAreClear() {
    assertThat(ComparableTimes.of(TIMES, List.of(List.of()))).containsExactly(0, 1, 2, 3, 4);
  }

  @Test
  void timesNearerToAJumpThanAQuarterOfTheirDistanceAreNot() {
    assertThat(ComparableTimes.of(TIMES, List.of(List.of(1.2, 2.7)))).containsExactly(0, 2, 3, 4);
    assertThat(ComparableTimes.of(TIMES, List.of(List.of(2.8)))).containsExactly(0, 1, 2, 4);
    assertThat(ComparableTimes.of(TIMES, List.of(List.of(3.0)))).containsExactly(0, 1, 2, 4);
  }

  @Test
  void betweenJumpsCloseToEachOtherAQuarterOfTheirDistanceIsEnough() {
    assertThat(ComparableTimes.of(TIMES, List.of(List.of(1.9, 2.1))))
        .containsExactly(0, 1, 2, 3, 4);
    assertThat(ComparableTimes.of(TIMES, List.of(List.of(1.96, 2.16)))).containsExactly(0, 1, 3, 4);
  }

  @Test
  void startIsKeptInAnyCase() {
    assertThat(ComparableTimes.of(TIMES, List.of(List.of(0.01)))).containsExactly(0, 1, 2, 3, 4);
  }

  @Test
  void timeBetweenTheSameJumpAsTwoCodesFoundItIsNotClear() {
    List<List<Double>> found = List.of(List.of(2 - 1e-9), List.of(2 + 1e-9));
    assertThat(ComparableTimes.of(TIMES, found)).containsExactly(0, 1, 3, 4);
  }
}
