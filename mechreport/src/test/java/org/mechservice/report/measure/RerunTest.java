package org.mechservice.report.measure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class RerunTest {
  private static final int POINTS = 20;

  private static MeasuredRun run(double tolerance, int round, double seconds, long steps) {
    return new MeasuredRun(
        "DTR DE",
        tolerance,
        round,
        "",
        seconds,
        1000,
        steps,
        2,
        20,
        1,
        3,
        new MeasuredRun.Errors(1e-7, 2e-7, 1e-8, 2e-7, 3e-5, 4e-13),
        1e-9,
        Map.of());
  }

  /** A report whose times scatter evenly by ten per cent about 1 s, times a factor per point. */
  private static List<Point> report(long steps, double factor, int slowPoints) {
    List<MeasuredRun> runs = new ArrayList<>();
    for (int i = 0; i < POINTS; i++) {
      double tolerance = 1e-3 / (i + 1);
      double slower = i < slowPoints ? factor : 1;
      for (int round = 0; round <= 11; round++) {
        runs.add(run(tolerance, round, slower * (0.95 + 0.01 * round), steps));
      }
    }
    return Point.of(runs);
  }

  @Test
  void timesWithinTheSpreadAreNoise() {
    Rerun rerun = Rerun.of(report(10, 1, 0), report(10, 1.05, POINTS));
    assertThat(rerun.agrees()).isTrue();
    assertThat(rerun.lines()).contains("rerun within noise").hasSize(6);
  }

  @Test
  void timesBeyondTheSpreadInMoreThanATenthOfThePointsAreNot() {
    assertThat(Rerun.of(report(10, 1, 0), report(10, 1.3, 2)).agrees()).isTrue();
    assertThat(Rerun.of(report(10, 1, 0), report(10, 1.3, 3)).agrees()).isFalse();
  }

  @Test
  void countThatDiffersIsNoNoise() {
    Rerun rerun = Rerun.of(report(10, 1, 0), report(11, 1, 0));
    assertThat(rerun.agrees()).isFalse();
    assertThat(rerun.lines()).contains("differs: DTR DE at 1e-03");
  }

  @Test
  void pointThatIsMissingIsNoNoise() {
    List<Point> all = report(10, 1, 0);
    assertThat(Rerun.of(all, all.subList(1, POINTS)).agrees()).isFalse();
    assertThat(Rerun.of(List.of(), List.of()).agrees()).isFalse();
  }
}
