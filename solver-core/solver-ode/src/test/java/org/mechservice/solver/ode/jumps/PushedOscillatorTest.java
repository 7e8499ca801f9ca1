package org.mechservice.solver.ode.jumps;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.adams.De;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.step.WatchedIntegrator;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.stiff.Ode15sR;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.switching.Switching;

/**
 * An oscillator at rest on which a force acts from t = 1 to t = 2 that is not declared (suite:
 * step_force): every integrator passes both jumps, with the search for them in fewer tries.
 */
class PushedOscillatorTest {
  private static final FunctionOde PUSHED =
      new FunctionOde(
          2,
          (t, y, yDot) -> {
            yDot[0] = y[1];
            yDot[1] = (t >= 1 && t < 2 ? 50 : 0) - 0.4 * y[1] - 100 * y[0];
          });

  /** Tries rejected near the first jump and near the second, and right digits at t = 5. */
  private record Passage(String method, long atFirst, long atSecond, double digits) {
    static Passage of(WatchedIntegrator integrator) {
      integrator.start(PUSHED, 0, new double[2], 5);
      long atFirst = 0;
      long atSecond = 0;
      StepResult result = StepResult.ADVANCED;
      while (result == StepResult.ADVANCED) {
        long before = integrator.statistics().rejectedSteps();
        double from = integrator.time();
        result = integrator.step();
        long rejected = integrator.statistics().rejectedSteps() - before;
        atFirst += from < 1.1 ? rejected : 0;
        atSecond += from >= 1.8 && from < 2.1 ? rejected : 0;
      }
      double[] atEnd = Run.state(integrator, 5, 2);
      double worst =
          Math.max(
              Math.abs(atEnd[0] - 0.18039197239119287) / 1.18,
              Math.abs(atEnd[1] - 4.400526629628046) / 5.4);
      return new Passage(
          integrator.getClass().getSimpleName(), atFirst, atSecond, -StrictMath.log10(worst));
    }
  }

  private static final List<Function<IntegratorSettings, WatchedIntegrator>> METHODS =
      List.of(Ode113::new, De::new, Ode15s::new, Ode15sR::new, Switching::new);

  private static List<Passage> passages(
      List<Function<IntegratorSettings, WatchedIntegrator>> methods,
      IntegratorSettings settings,
      UnaryOperator<WatchedIntegrator> watched) {
    return methods.stream()
        .map(method -> Passage.of(watched.apply(method.apply(settings))))
        .toList();
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 4, 5, 6, 7, 8, 9})
  void searchedJumpCostsAtMost25RejectedSteps(int k) {
    double tolerance = StrictMath.pow(10, -k);
    IntegratorSettings standard = new IntegratorSettings(tolerance, tolerance);
    List<Passage> passages =
        Stream.concat(
                passages(METHODS, standard, UndeclaredJumps::around).stream(),
                passages(
                    List.of(Ode15s::new, Ode15sR::new),
                    standard.withMode(Mode.STRICT),
                    UndeclaredJumps::around)
                    .stream())
            .toList();
    assertThat(passages)
        .allMatch(passage -> passage.atFirst() <= 25 && passage.atSecond() <= 25)
        .allMatch(passage -> passage.digits() >= k - 2);
  }

  /**
   * By error tests alone. The step across is as long as J h is of the tolerance: halvings bring the
   * tries there from the far side, and as many again the steps of the near side, which grow
   * meanwhile.
   */
  @ParameterizedTest
  @ValueSource(ints = {3, 4, 5, 6, 7, 8, 9, 10, 11})
  void jumpIsPassedWithoutTheSearch(int k) {
    double tolerance = StrictMath.pow(10, -k);
    double halvings = StrictMath.log(50 / tolerance) / StrictMath.log(2);
    IntegratorSettings standard = new IntegratorSettings(tolerance, tolerance);
    assertThat(passages(METHODS, standard, UnaryOperator.identity()))
        .allMatch(passage -> passage.atFirst() <= 2 * halvings)
        .allMatch(passage -> passage.atSecond() <= 2 * halvings)
        .allMatch(passage -> passage.digits() >= k - 2);
  }
}
