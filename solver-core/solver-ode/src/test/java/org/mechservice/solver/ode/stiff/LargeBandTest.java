package org.mechservice.solver.ode.stiff;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.suite.HeatRod;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.switching.Switching;

/** Costs of a problem with a declared band grow with the band, not with the number of unknowns. */
class LargeBandTest {
  private static final IntegratorSettings SETTINGS = new IntegratorSettings(1e-4, 1e-6);

  /** Enough for a run that is not held back by stability. */
  private static final long MOST_STEPS = 2000;

  private static long evaluations(int n, Mode mode) {
    HeatRod rod = new HeatRod(n);
    Run run = Run.of(new Ode15s(SETTINGS.withMode(mode)), rod, 0, rod.initialState(), 0.1);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(run.atEnd()).containsExactly(rod.at(0.1), within(1e-3));
    return run.statistics().evaluations();
  }

  @ParameterizedTest
  @EnumSource
  void evaluationsDoNotGrowWithTheNumberOfUnknowns(Mode mode) {
    long few = evaluations(500, mode);
    assertThat(few).isLessThan(100);
    assertThat(evaluations(20_000, mode)).isLessThanOrEqualTo(few + 20);
  }

  @Test
  void switchingLeavesALargeBandToTheStiffMethod() {
    HeatRod rod = new HeatRod(5000);
    IntegratorSettings bounded =
        new IntegratorSettings(
            1e-4, List.of(1e-6), Double.POSITIVE_INFINITY, 0, 0, MOST_STEPS, () -> false);
    Run run = Run.of(new Switching(bounded), rod, 0, rod.initialState(), 0.1);
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(run.atEnd()).containsExactly(rod.at(0.1), within(1e-3));
    assertThat(run.integrator().methodChangeCount()).isEqualTo(1);
    assertThat(run.statistics().evaluations()).isLessThan(200);
  }
}
