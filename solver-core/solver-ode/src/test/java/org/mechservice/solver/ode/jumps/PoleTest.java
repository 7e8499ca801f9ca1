package org.mechservice.solver.ode.jumps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.Function;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.adams.De;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.solve.Ode;
import org.mechservice.solver.ode.solve.OdeFunction;
import org.mechservice.solver.ode.solve.OdeMethod;
import org.mechservice.solver.ode.solve.OdeOptions;
import org.mechservice.solver.ode.solve.OdeSolution;
import org.mechservice.solver.ode.step.WatchedIntegrator;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.switching.Switching;

/**
 * No run goes on beyond a place where the solution grows beyond every bound, wherever steps happen
 * to fall; runs whose derivative alone has no bound go on.
 */
@Tag("slow")
class PoleTest {
  private static final double[] TOLERANCES = {1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 1e-6};
  private static final int PLACES = 60;

  private enum Method {
    ODE113(Ode113::new),
    DE(De::new),
    ODE15S(Ode15s::new),
    SWITCHING(Switching::new);

    @SuppressWarnings("ImmutableEnumChecker") // a constructor, no state
    private final Function<IntegratorSettings, WatchedIntegrator> maker;

    Method(Function<IntegratorSettings, WatchedIntegrator> maker) {
      this.maker = maker;
    }

    Integrator searched(double tolerance) {
      return UndeclaredJumps.around(maker.apply(new IntegratorSettings(tolerance, tolerance)));
    }
  }

  private interface Slope {
    double at(double t, double y);
  }

  private static OdeSystem system(Slope slope) {
    return new OdeSystem() {
      @Override
      public int dimension() {
        return 1;
      }

      @Override
      public void derivative(double t, double[] y, double[] yDot) {
        yDot[0] = slope.at(t, y[0]);
      }
    };
  }

  private static double place(int i) {
    return 0.3 + 1.4 * i / (PLACES - 1) * 0.999;
  }

  /** Returns whether a run to 2 ends by name near a place, as far as its tolerance knows it. */
  private static boolean endsAt(double place, Slope slope, Method method, double tolerance) {
    Integrator run = method.searched(tolerance);
    StepResult result = run.start(system(slope), 0, new double[] {0}, 2);
    while (result == StepResult.ADVANCED) {
      result = run.step();
    }
    if (result != StepResult.FAILED) {
      return false;
    }
    double ahead = place - run.time();
    return run.failure().cause() == Cause.UNBOUNDED
        ? ahead >= 0 && ahead <= run.failure().stepSize()
        : Math.abs(ahead) < 0.1;
  }

  /** Without the search: where the tolerance is tight enough for plain error tests to see it. */
  @ParameterizedTest
  @EnumSource
  void plainStepsCrossNoPoleAtTightTolerances(Method method) {
    for (double tolerance : new double[] {1e-6, 1e-8, 1e-10}) {
      for (int i = 0; i < PLACES; i += 3) {
        double c = place(i);
        List<Slope> slopes =
            List.of(
                (t, y) -> 1 / (c - t),
                (t, y) -> 1 / Math.abs(c - t),
                (t, y) -> 1 / ((c - t) * (c - t)),
                (t, y) -> StrictMath.tan(0.5 * Math.PI * t / c));
        for (Slope slope : slopes) {
          Integrator run = method.maker.apply(new IntegratorSettings(tolerance, tolerance));
          StepResult result = run.start(system(slope), 0, new double[] {0}, 2);
          while (result == StepResult.ADVANCED) {
            result = run.step();
          }
          assertThat(result).as("%s, %s, %s", method, tolerance, c).isEqualTo(StepResult.FAILED);
        }
      }
    }
  }

  private static int missed(Function<Double, Slope> slopes, Method method) {
    return missed(slopes, method, 1);
  }

  /** Counts the poles that are missed at every so many of the places. */
  private static int missed(Function<Double, Slope> slopes, Method method, int distance) {
    int missed = 0;
    for (double tolerance : TOLERANCES) {
      for (int i = 0; i < PLACES; i += distance) {
        missed += endsAt(place(i), slopes.apply(place(i)), method, tolerance) ? 0 : 1;
      }
    }
    return missed;
  }

  @ParameterizedTest
  @EnumSource
  void noPoleOfFirstOrderIsCrossed(Method method) {
    assertThat(missed(c -> (t, y) -> 1 / (c - t), method)).isZero();
  }

  @ParameterizedTest
  @EnumSource
  void noPoleOfThirdOrderIsCrossed(Method method) {
    assertThat(missed(c -> (t, y) -> 1 / ((c - t) * (c - t) * (c - t)), method)).isZero();
  }

  @ParameterizedTest
  @EnumSource
  void noPoleOfConstantSignIsCrossed(Method method) {
    assertThat(missed(c -> (t, y) -> 1 / Math.abs(c - t), method)).isZero();
    assertThat(missed(c -> (t, y) -> -1 / Math.abs(c - t), method)).isZero();
  }

  @ParameterizedTest
  @EnumSource
  void noPoleOfSecondOrderIsCrossed(Method method) {
    assertThat(missed(c -> (t, y) -> 1 / ((c - t) * (c - t)), method)).isZero();
    assertThat(missed(c -> (t, y) -> StrictMath.cos(3 * t) + 1 / ((c - t) * (c - t)), method))
        .isZero();
  }

  @ParameterizedTest
  @EnumSource
  void noPoleOfATangentIsCrossed(Method method) {
    assertThat(missed(c -> (t, y) -> StrictMath.tan(0.5 * Math.PI * t / c), method)).isZero();
  }

  @ParameterizedTest
  @EnumSource
  void noPoleOfAnyOtherOrderIsCrossed(Method method) {
    for (double order : new double[] {1.1, 1.5, 1.75, 2.5, 5}) {
      assertThat(missed(c -> (t, y) -> StrictMath.pow(Math.abs(c - t), -order), method, 4))
          .as("order %s", order)
          .isZero();
    }
  }

  /** Where f depends on y, the value behind the pole is another. */
  @ParameterizedTest
  @EnumSource
  void noPoleOfALinearEquationIsCrossed(Method method) {
    for (double factor : new double[] {1, 3}) {
      assertThat(missed(c -> (t, y) -> factor * (1 + y) / Math.abs(c - t), method, 4))
          .as("factor %s", factor)
          .isZero();
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e6, 1e-6, 1e-150})
  void unitsOfTimeDoNotMatter(double unit) {
    for (Method method : Method.values()) {
      for (double tolerance : TOLERANCES) {
        for (int i = 0; i < PLACES; i += 7) {
          double c = unit * place(i);
          Integrator run = method.searched(tolerance);
          StepResult result =
              run.start(system((t, y) -> 1 / (c - t)), 0, new double[] {0}, 2 * unit);
          while (result == StepResult.ADVANCED) {
            result = run.step();
          }
          assertThat(result).as("%s, %s", method, c).isEqualTo(StepResult.FAILED);
          assertThat(run.time() / unit).as("%s, %s", method, c).isCloseTo(place(i), within(0.1));
        }
      }
    }
  }

  /** The library calls every one of them by its name, wherever it is noticed. */
  @ParameterizedTest
  @EnumSource(names = "ODE15SR", mode = EnumSource.Mode.EXCLUDE)
  void solutionsThatGrowBeyondEveryBoundAreNamed(OdeMethod method) {
    List<OdeFunction> problems =
        List.of(
            (t, y, yDot) -> yDot[0] = 0.5 * Math.PI * (1 + y[0] * y[0]),
            (t, y, yDot) -> yDot[0] = (1 + y[0]) * (1 + y[0]),
            (t, y, yDot) -> yDot[0] = StrictMath.exp(y[0]),
            (t, y, yDot) -> yDot[0] = 0.5 * (1 + y[0]) * (1 + y[0]) * (1 + y[0]));
    for (OdeFunction problem : problems) {
      OdeFunction besideAnOscillator =
          (t, y, yDot) -> {
            problem.evaluate(t, y, yDot);
            yDot[1] = y[2];
            yDot[2] = -25 * y[1];
          };
      for (double tolerance : new double[] {1e-4, 1e-6, 1e-9}) {
        OdeOptions options =
            OdeOptions.standard()
                .searchUndeclaredJumps()
                .method(method)
                .rtol(tolerance)
                .atol(tolerance)
                .returnFailures();
        OdeSolution solution = Ode.solve(besideAnOscillator, 0, new double[] {0, 1, 0}, 2, options);
        assertThat(solution.failure()).isPresent();
        assertThat(solution.failure().get().cause()).isEqualTo(Cause.UNBOUNDED);
        assertThat(solution.failure().get().worstComponent()).isZero();
        assertThat(solution.end()).isCloseTo(1, within(0.05));
      }
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"ODE113", "DE"})
  void solutionThatStaysBoundedGoesOn(Method method) {
    for (double tolerance : TOLERANCES) {
      for (int i = 0; i < PLACES; i++) {
        double c = place(i);
        Integrator run = method.searched(tolerance);
        Slope root = (t, y) -> -Math.signum(c - t) * 0.5 / Math.sqrt(Math.abs(c - t));
        StepResult result = run.start(system(root), 0, new double[] {0}, 2);
        while (result == StepResult.ADVANCED) {
          result = run.step();
        }
        assertThat(result).as("%s, %s, %s", method, tolerance, c).isEqualTo(StepResult.REACHED_END);
      }
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"ODE113", "DE"})
  void poleCrossedAtLooseTolerancesIsNamed(Method method) {
    Integrator run = method.searched(1e-2);
    StepResult result = run.start(system((t, y) -> 1 / (1 - t)), 0, new double[] {0}, 2);
    while (result == StepResult.ADVANCED) {
      result = run.step();
    }
    assertThat(run.failure().cause()).isIn(Cause.UNBOUNDED, Cause.STEP_TOO_SMALL);
  }

  /**
   * Oscillators of their own frequencies, each with a ripple far below the tolerance and too fast
   * for the steps. In a large system some derivative passes zero, and some ripple looks like a
   * pole, in every step.
   */
  private static OdeSystem oscillators(int count) {
    return new OdeSystem() {
      @Override
      public int dimension() {
        return 3 * count;
      }

      @Override
      public void derivative(double t, double[] y, double[] yDot) {
        for (int i = 0; i < count; i++) {
          double frequency = 1 + (double) i / count;
          yDot[3 * i] = y[3 * i + 1];
          yDot[3 * i + 1] = -frequency * frequency * y[3 * i];
          yDot[3 * i + 2] = 1e-9 * StrictMath.cos((40 + i) * t);
        }
      }
    };
  }

  @ParameterizedTest
  @EnumSource(names = {"ODE113", "DE"})
  void stepTakesTwoEvaluationsHoweverLargeTheSystem(Method method) {
    for (double tolerance : new double[] {1e-2, 1e-3, 1e-6}) {
      for (int count : new int[] {1, 10, 1000}) {
        Integrator run = method.searched(tolerance);
        double[] y0 = new double[3 * count];
        for (int i = 0; i < count; i++) {
          y0[3 * i] = StrictMath.cos(i);
          y0[3 * i + 1] = StrictMath.sin(i);
        }
        StepResult result = run.start(oscillators(count), 0, y0, 20);
        while (result == StepResult.ADVANCED) {
          result = run.step();
        }
        assertThat(result).isEqualTo(StepResult.REACHED_END);
        long tried = run.statistics().steps() + run.statistics().rejectedSteps();
        assertThat(run.statistics().evaluations())
            .as("%s oscillators at %s", count, tolerance)
            .isLessThanOrEqualTo(2 * tried + 2);
      }
    }
  }
}
