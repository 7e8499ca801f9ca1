package org.mechservice.sim.service.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.idl.CurveSample;

class CurveHistoryTest {
  private static final int STEPS = 500_000;

  private static CurveHistory calmRunWithPeaksAt(int peak) {
    CurveHistory history = new CurveHistory();
    for (int i = 0; i < STEPS; i++) {
      boolean inPeak = i == peak;
      history.add(
          1000L + i,
          i * 1e-3,
          inPeak ? 1e-12 : 1e-3,
          inPeak ? 1 : 4,
          inPeak ? -7 : 1e-6,
          inPeak ? 0.5 : 1e-9);
    }
    return history;
  }

  private static double least(List<CurveSample> curve, ToDoubleFunction<CurveSample> quantity) {
    return curve.stream().mapToDouble(quantity).min().orElseThrow();
  }

  private static double largest(List<CurveSample> curve, ToDoubleFunction<CurveSample> quantity) {
    return curve.stream().mapToDouble(quantity).max().orElseThrow();
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 777, 250_001, STEPS - 2, STEPS - 1})
  void peakOfOneSampleStaysHoweverLongTheRun(int peak) {
    List<CurveSample> curve = calmRunWithPeaksAt(peak).samples();
    assertThat(curve).hasSizeLessThanOrEqualTo(601);
    assertThat(least(curve, sample -> sample.stepSize)).isEqualTo(1e-12);
    assertThat(least(curve, sample -> sample.stepOrder)).isEqualTo(1);
    assertThat(least(curve, sample -> sample.energyDrift)).isEqualTo(-7);
    assertThat(largest(curve, sample -> sample.residual)).isEqualTo(0.5);
  }

  @Test
  void timeNeverDecreasesAndTheLatestSampleEndsTheCurve() {
    CurveHistory history = new CurveHistory();
    for (int i = 0; i < 10_000; i++) {
      // Rows lie inside the step that is finished.
      history.add(i, i % 2 == 0 ? i : i - 1.5, i, 3, Math.sin(i), Math.cos(i));
    }
    List<CurveSample> curve = history.samples();
    assertThat(curve).isSortedAccordingTo((a, b) -> Double.compare(a.simTime, b.simTime));
    CurveSample last = curve.get(curve.size() - 1);
    assertThat(last.stepSize).isEqualTo(9999);
    assertThat(last.energyDrift).isEqualTo(Math.sin(9999));
  }

  @Test
  void extremesOfAnIntervalKeepTheOrderInWhichTheyOccurred() {
    CurveHistory history = new CurveHistory();
    for (int i = 0; i < 600; i++) {
      history.add(i, i, 1 + i, 3, -i, 0);
    }
    List<CurveSample> curve = history.samples();
    assertThat(curve).isSortedAccordingTo((a, b) -> Double.compare(a.stepSize, b.stepSize));
    assertThat(curve).isSortedAccordingTo((a, b) -> Double.compare(b.energyDrift, a.energyDrift));
  }

  @Test
  void quantityThatIsNotPutOutStaysWithoutValues() {
    CurveHistory history = new CurveHistory();
    for (int i = 0; i < 2000; i++) {
      history.add(i, i, 1, 3, Double.NaN, i < 1000 ? Double.NaN : 2);
    }
    assertThat(history.samples()).isNotEmpty().allMatch(sample -> Double.isNaN(sample.energyDrift));
    assertThat(largest(history.samples().stream().skip(400).toList(), s -> s.residual))
        .isEqualTo(2);
  }

  @Test
  void shortRunKeepsEverySample() {
    CurveHistory history = new CurveHistory();
    for (int i = 0; i < 300; i++) {
      history.add(i, i, i, 2, 0, 0);
    }
    assertThat(history.samples()).hasSize(300);
  }
}
