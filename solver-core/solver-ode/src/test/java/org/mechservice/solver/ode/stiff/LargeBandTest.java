package org.mechservice.solver.ode.stiff;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.solve.Ode;
import org.mechservice.solver.ode.solve.OdeMethod;
import org.mechservice.solver.ode.solve.OdeOptions;
import org.mechservice.solver.ode.solve.OdeProblem;
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

  /** Seven diagonals and a square, as a band, as a pattern, in residual form, wrapped twice. */
  @ParameterizedTest
  @EnumSource(names = {"ODE15S", "ODE15SR", "AUTO"})
  void formInWhichTheStructureIsKnownDoesNotMatter(OdeMethod method) {
    for (int form = 0; form < 3; form++) {
      long few = evaluations(200, form, method);
      assertThat(few).isLessThan(400);
      // AUTO may take longer to find out that the problem is stiff.
      long most = method == OdeMethod.AUTO ? 400 : few + 20;
      assertThat(evaluations(3000, form, method)).isLessThanOrEqualTo(most);
    }
  }

  private static long evaluations(int n, int form, OdeMethod method) {
    OdeProblem plain = Ode.system(n, LargeBandTest::coupled);
    OdeProblem problem =
        switch (form) {
          case 0 -> plain.withBand(3, 3);
          case 1 -> plain.withPatternByColumns(j -> neighbours(j, n));
          default ->
              plain
                  .withBand(3, 3)
                  .withFunction(f -> (t, y, yDot) -> f.evaluate(t, y, yDot))
                  .withFunction(f -> (t, y, yDot) -> f.evaluate(t, y, yDot));
        };
    OdeOptions options =
        OdeOptions.standard().method(method).rtol(1e-4).atol(1e-6).keepSteps(false);
    double[] start = new double[n];
    Arrays.fill(start, 1);
    return Ode.solve(problem, 0, start, 0.1, options).statistics().evaluations();
  }

  private static int[] neighbours(int j, int n) {
    return IntStream.rangeClosed(Math.max(0, j - 3), Math.min(n - 1, j + 3)).toArray();
  }

  private static void coupled(double t, double[] y, double[] yDot) {
    for (int i = 0; i < y.length; i++) {
      double sum = 0;
      for (int j = Math.max(0, i - 3); j <= Math.min(y.length - 1, i + 3); j++) {
        sum += 3000 * y[j] / (1 + Math.abs(i - j));
      }
      yDot[i] = 1000 * StrictMath.cos(t) - sum - y[i] * y[i];
    }
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
