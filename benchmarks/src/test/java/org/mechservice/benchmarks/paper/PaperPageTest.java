package org.mechservice.benchmarks.paper;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.mechservice.benchmarks.paper.PaperReport.DampingPoint;
import org.mechservice.benchmarks.paper.PaperReport.RunPair;
import org.mechservice.benchmarks.paper.PaperReport.Timed;
import org.mechservice.report.measure.MeasuredRun;

class PaperPageTest {
  private static Timed timed(double seconds, long evaluations) {
    MeasuredRun run =
        new MeasuredRun(
            "DTR DE",
            1e-5,
            1,
            "",
            seconds,
            0,
            100,
            0,
            evaluations,
            0,
            0,
            MeasuredRun.Errors.NONE,
            0,
            Map.of());
    return new Timed(seconds, 0.99 * seconds, 1.02 * seconds, run);
  }

  private static RunPair pair(double gain, double atEqualError) {
    return new RunPair(
        timed(gain, 1000),
        timed(1, 500),
        List.of(equalErrors(1, atEqualError), equalErrors(0.01, 0.5 * atEqualError)));
  }

  private static EqualErrors equalErrors(double absolutePart, double ratio) {
    return new EqualErrors(
        absolutePart,
        List.of(
            new EqualErrors.Ratio(1e-4, ratio, ratio),
            new EqualErrors.Ratio(1e-6, Double.NaN, Double.NaN)));
  }

  private static List<DampingPoint> sweep(double... gains) {
    return List.of(
        new DampingPoint(0, pair(gains[0], 1)),
        new DampingPoint(1e-3, pair(gains[1], 1)),
        new DampingPoint(1e-2, pair(gains[2], 1)));
  }

  private static String page() {
    Map<PaperFigures.Scene, RunPair> runs = new EnumMap<>(PaperFigures.Scene.class);
    runs.put(PaperFigures.Scene.PENDULUM, pair(0.6, 0.4));
    runs.put(PaperFigures.Scene.DRIVER, pair(0.5, 0.3));
    runs.put(PaperFigures.Scene.DAMPED_DRIVER, pair(20, 7.5));
    Map<PaperFigures.Scene, Map<String, Double>> setUp = new EnumMap<>(PaperFigures.Scene.class);
    setUp.put(PaperFigures.Scene.PENDULUM, Map.of("modelClassBytes", 3600.0));
    return PaperPage.of(setUp, runs, sweep(0.1, 0.5, 2));
  }

  @Test
  void crossoverLiesWhereTheTimesAreEqualInLogarithms() {
    assertThat(PaperPage.crossoverDamping(sweep(0.1, 0.5, 2), p -> p.explicit().seconds()))
        .hasValueCloseTo(Math.sqrt(1e-5), Offset.offset(1e-12));
  }

  @Test
  void thereIsNoCrossoverWhereOneMethodWinsThroughout() {
    assertThat(PaperPage.crossoverDamping(sweep(0.1, 0.2, 0.3), p -> p.explicit().seconds()))
        .isEmpty();
  }

  @Test
  void shapeIsToldInWordsWithItsNumbers() {
    assertThat(page())
        .contains("the <b>explicit</b> method wins by 2.00×")
        .contains("the <b>implicit</b> method wins by 20.0×")
        .contains("at equal error 1e-4: the implicit method needs <b>7.5</b>")
        .contains("<b>C/K = 0.0032 s</b>");
  }

  @Test
  void equalErrorsAreToldForBothWaysToWeighTolerances() {
    assertThat(page())
        .contains("<tr><td>1e-4, atol = rtol<td>", "<tr><td>1e-4, atol = rtol / 100<td>")
        .contains("3.8 and 3.8 times with absolute tolerances of a hundredth");
  }

  @Test
  void errorThatIsNotReachedHasNoRatio() {
    assertThat(page()).doesNotContain("NaN").contains("–: one of the two does not reach");
  }

  @Test
  void figuresOfThePaperStandAsItPrintedThem() {
    assertThat(page()).contains("<td>8.40", "<td>0.10", "<td>125.0", "<b>3.6</b><td>2.2");
  }
}
