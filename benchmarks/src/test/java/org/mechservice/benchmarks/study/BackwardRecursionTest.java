package org.mechservice.benchmarks.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.stiff.Ode15s;

/** The formulas of ode15s along the imaginary axis. */
class BackwardRecursionTest {
  /** Of higher orders it holds none, so this is where formula and integrator can be compared. */
  @ParameterizedTest
  @ValueSource(doubles = {0.01, 0.1, 1})
  void orderOneIsWhatTheIntegratorDoes(double size) {
    IntegratorSettings held =
        new IntegratorSettings(0.5, List.of(1e30), size, size, 1, Long.MAX_VALUE, () -> false);
    Ode15s integrator = new Ode15s(held);
    double[] y = {1, 0};
    double[] slope = new double[2];
    int steps = (int) Math.min(3000, 60 / size);
    StepResult result = integrator.start(new Oscillator(1), 0, y, 10 * steps * size);
    double before = 0;
    double beforeTime = 0;
    for (int i = 0; i < steps && result == StepResult.ADVANCED; i++) {
      result = integrator.step();
      if (i == steps / 2) {
        integrator.interpolate(integrator.time(), y, slope);
        before = Math.hypot(y[0], y[1]);
        beforeTime = integrator.time();
      }
    }
    integrator.interpolate(integrator.time(), y, slope);
    double turns = (integrator.time() - beforeTime) / (2 * Math.PI);
    double measured = Math.pow(Math.hypot(y[0], y[1]) / before, 1 / turns);
    // The integrator stays real, so its amplitude swings a little about the trend.
    assertThat(new BackwardRecursion(1).growthPerPeriod(size))
        .isCloseTo(measured, within(0.02 * measured));
  }

  /**
   * The local error is of order k + 1 in h; along the imaginary axis it turns the phase if k is
   * even, and the amplitude feels the next order alone; of order 2, whose κ is the largest that
   * keeps it A-stable, the one after that.
   */
  @ParameterizedTest
  @CsvSource({"1, 1", "2, 5", "3, 3", "4, 5", "5, 5"})
  void growthPerPeriodFallsWithTheStepByItsOrder(int order, double power) {
    BackwardRecursion formula = new BackwardRecursion(order);
    double coarse = Math.abs(formula.growthPerPeriod(0.08) - 1);
    double fine = Math.abs(formula.growthPerPeriod(0.04) - 1);
    assertThat(Math.log(coarse / fine) / Math.log(2)).isCloseTo(power, within(0.2));
  }

  /** Formulas of order 1 and 2 are A-stable (Shampine and Reichelt 1997, table 1). */
  @Test
  void ordersOneAndTwoNeverGrowAndOrderFiveDoes() {
    double worst = 0;
    for (double size : new double[] {0.1, 0.5, 1, 2, 3, 5, 10}) {
      assertThat(new BackwardRecursion(1).growthPerPeriod(size)).isLessThanOrEqualTo(1);
      assertThat(new BackwardRecursion(2).growthPerPeriod(size)).isLessThanOrEqualTo(1 + 1e-9);
      worst = Math.max(worst, new BackwardRecursion(5).growthPerPeriod(size));
    }
    assertThat(worst).isGreaterThan(1.5);
  }
}
