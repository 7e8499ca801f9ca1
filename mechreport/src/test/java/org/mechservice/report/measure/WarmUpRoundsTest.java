package org.mechservice.report.measure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleSupplier;
import org.junit.jupiter.api.Test;

class WarmUpRoundsTest {
  private final List<Double> rounds = new ArrayList<>();

  /** Rounds that last so long one after the other, the last one for ever. */
  private DoubleSupplier lasting(double... seconds) {
    return () -> {
      double next = seconds[Math.min(rounds.size(), seconds.length - 1)];
      rounds.add(next);
      return next;
    };
  }

  @Test
  void roundsAreRepeatedUntilTheyGetNoFaster() {
    WarmUpRounds.until(lasting(1.5, 1.4, 1.3, 1.2, 1.2), 1, ReportProgress.SILENT, 0);
    assertThat(rounds).containsExactly(1.5, 1.4, 1.3, 1.2, 1.2);
  }

  @Test
  void shortRoundsAreComparedInBlocks() {
    WarmUpRounds.until(lasting(0.25), 1, ReportProgress.SILENT, 0);
    assertThat(rounds).hasSize(8);
  }

  @Test
  void machineThatIsNeverSteadyIsNotWaitedForWithoutEnd() {
    double[] falling = new double[1000];
    falling[0] = 1.2;
    for (int i = 1; i < falling.length; i++) {
      falling[i] = 0.97 * falling[i - 1];
    }
    WarmUpRounds.until(lasting(falling), 0.1, ReportProgress.SILENT, 0);
    assertThat(rounds).hasSizeLessThan(10);
  }
}
