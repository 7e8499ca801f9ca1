package org.mechservice.solver.ode;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.adams.De;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.stiff.Ode15sR;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.switching.Switching;

/**
 * Problems of the literature that are not in the suite, judged by a run at a much smaller
 * tolerance: no method may end one with a result that is wrong and unsaid.
 */
class FurtherProblemsTest {
  /** A problem, the size below which its components are negligible, and whether it is stiff. */
  private record Problem(
      String name,
      boolean stiff,
      List<Double> start,
      double end,
      double scale,
      FunctionOde equations) {
    double[] initialState() {
      return start.stream().mapToDouble(Double::doubleValue).toArray();
    }

    Run run(IntegratorFactory integrators, double tolerance) {
      IntegratorSettings settings = new IntegratorSettings(tolerance, tolerance * scale);
      return Run.of(integrators.create(settings), equations, 0, initialState(), end);
    }

    @Override
    public String toString() {
      return name;
    }
  }

  private static Problem problem(
      String name,
      boolean stiff,
      List<Double> start,
      double end,
      double scale,
      FunctionOde.Equation equation) {
    return new Problem(name, stiff, start, end, scale, new FunctionOde(start.size(), equation));
  }

  static Stream<Problem> problems() {
    return Stream.of(
        // Field and Noyes 1974: the Belousov-Zhabotinskii reaction, by one period and a bit.
        problem(
            "Oregonator",
            true,
            List.of(1.0, 2.0, 3.0),
            360,
            1,
            (t, y, d) -> {
              d[0] = 77.27 * (y[1] + y[0] * (1 - 8.375e-6 * y[0] - y[1]));
              d[1] = (y[2] - (1 + y[0]) * y[1]) / 77.27;
              d[2] = 0.161 * (y[0] - y[2]);
            }),
        // Enright, Hull and Lindberg 1975, D4: a chemical reaction of Gear's.
        problem(
            "DetestD4",
            true,
            List.of(1.0, 1.0, 0.0),
            50,
            1e-3,
            (t, y, d) -> {
              d[0] = -0.013 * y[0] - 1000 * y[0] * y[2];
              d[1] = -2500 * y[1] * y[2];
              d[2] = -0.013 * y[0] - 1000 * y[0] * y[2] - 2500 * y[1] * y[2];
            }),
        // Van der Pol with mu = 1000 in its own time scale, epsilon = 1e-6, past two jumps.
        problem(
            "VanDerPolMillion",
            true,
            List.of(2.0, -0.66),
            2,
            1,
            (t, y, d) -> {
              d[0] = y[1];
              d[1] = ((1 - y[0] * y[0]) * y[1] - y[0]) * 1e6;
            }),
        // Kaps 1981: singular perturbation with a smooth solution.
        problem(
            "Kaps",
            true,
            List.of(1.0, 1.0),
            5,
            1e-3,
            (t, y, d) -> {
              d[0] = -1e5 * (y[0] - y[1] * y[1]) - 2 * y[0];
              d[1] = y[0] - y[1] * (1 + y[1]);
            }),
        // Enright, Hull and Lindberg 1975, E5: concentrations down to 1e-22, rates up to 1e9.
        problem(
            "DetestE5",
            true,
            List.of(1.76e-3, 0.0, 0.0, 0.0),
            1e5,
            1e-14,
            (t, y, d) -> {
              d[0] = -7.89e-10 * y[0] - 1.1e7 * y[0] * y[2];
              d[1] = 7.89e-10 * y[0] - 1.13e9 * y[1] * y[2];
              d[3] = 1.1e7 * y[0] * y[2] - 1130 * y[3];
              d[2] = d[1] - d[3];
            }),
        // A rectifier: the current through the diode spans 40 decades within a period.
        problem(
            "Rectifier",
            true,
            List.of(0.0),
            0.05,
            1e-2,
            (t, y, d) -> {
              double across = 5 * StrictMath.sin(314.159265 * t) - y[0];
              d[0] = 1e-3 * (StrictMath.exp(across / 0.05) - 1) - 1e3 * y[0];
            }),
        // A mass on a spring whose other end moves, far more than critically damped.
        problem(
            "OverdampedMass",
            true,
            List.of(1.0, 0.0),
            10,
            1e-2,
            (t, y, d) -> {
              d[0] = y[1];
              d[1] = -1e4 * y[1] - 1e6 * (y[0] - StrictMath.sin(t));
            }),
        // A rod of 30 pieces, heated in turns at one end.
        problem(
            "HeatedRod",
            true,
            Collections.nCopies(30, 0.0),
            1,
            1e-3,
            (t, y, d) -> {
              for (int i = 0; i < 30; i++) {
                double left = i > 0 ? y[i - 1] : 0;
                double right = i < 29 ? y[i + 1] : StrictMath.sin(5 * t);
                d[i] = 961 * (left - 2 * y[i] + right);
              }
            }),
        // A free body that turns over about its middle axis: Euler parameters, then its own axes.
        problem(
            "TurningOver",
            false,
            List.of(1.0, 0.0, 0.0, 0.0, 0.01, 1.0, 0.01),
            40,
            1,
            (t, y, d) -> {
              d[0] = 0.5 * (-y[1] * y[4] - y[2] * y[5] - y[3] * y[6]);
              d[1] = 0.5 * (y[0] * y[4] + y[2] * y[6] - y[3] * y[5]);
              d[2] = 0.5 * (y[0] * y[5] - y[1] * y[6] + y[3] * y[4]);
              d[3] = 0.5 * (y[0] * y[6] + y[1] * y[5] - y[2] * y[4]);
              d[4] = -y[5] * y[6];
              d[5] = y[4] * y[6];
              d[6] = -y[4] * y[5] / 3;
            }),
        problem(
            "LorenzShort",
            false,
            List.of(1.0, 1.0, 1.0),
            5,
            1,
            (t, y, d) -> {
              d[0] = 10 * (y[1] - y[0]);
              d[1] = y[0] * (28 - y[2]) - y[1];
              d[2] = y[0] * y[1] - 8.0 / 3 * y[2];
            }),
        problem(
            "LotkaVolterra",
            false,
            List.of(1.0, 3.0),
            20,
            1,
            (t, y, d) -> {
              d[0] = 2 * y[0] * (1 - y[1]);
              d[1] = -y[1] * (1 - y[0]);
            }),
        problem(
            "DoublePendulum",
            false,
            List.of(2.0, 0.5, 0.0, 0.0),
            3,
            1,
            (t, y, d) -> {
              double c = StrictMath.cos(y[0] - y[1]);
              double s = StrictMath.sin(y[0] - y[1]);
              double a = -y[3] * y[3] * s - 2 * 9.81 * StrictMath.sin(y[0]);
              double b = y[2] * y[2] * s - 9.81 * StrictMath.sin(y[1]);
              d[0] = y[2];
              d[1] = y[3];
              d[2] = (a - c * b) / (2 - c * c);
              d[3] = (2 * b - c * a) / (2 - c * c);
            }),
        // Henon and Heiles 1964, a regular orbit.
        problem(
            "HenonHeiles",
            false,
            List.of(0.0, 0.1, 0.35, 0.1),
            50,
            1,
            (t, y, d) -> {
              d[0] = y[2];
              d[1] = y[3];
              d[2] = -y[0] - 2 * y[0] * y[1];
              d[3] = -y[1] - y[0] * y[0] + y[1] * y[1];
            }),
        // A damped oscillator pushed by a square wave whose jumps nobody declares.
        problem(
            "SquareWave",
            false,
            List.of(0.0, 0.0),
            10,
            1,
            (t, y, d) -> {
              d[0] = y[1];
              d[1] = (t - 2 * Math.floor(t / 2) < 1 ? 1 : -1) - 0.5 * y[1] - 4 * y[0];
            }));
  }

  private static double digits(Problem problem, double[] y, double[] reference) {
    double worst = 0;
    for (int i = 0; i < y.length; i++) {
      double allowed = Math.abs(reference[i]) + problem.scale();
      worst = Math.max(worst, Math.abs(y[i] - reference[i]) / allowed);
    }
    return -StrictMath.log10(worst);
  }

  @ParameterizedTest
  @MethodSource("problems")
  void noMethodEndsWithFarFewerDigitsThanAskedFor(Problem problem) {
    IntegratorFactory accurate =
        settings -> problem.stiff() ? new Ode15s(settings) : new Ode113(settings);
    double[] reference = problem.run(accurate, 1e-12).atEnd();
    List<IntegratorFactory> integrators =
        problem.stiff()
            ? List.of(Ode15s::new, Ode15sR::new, Switching::new)
            : List.of(Ode113::new, De::new, Ode15s::new, Ode15sR::new, Switching::new);
    for (IntegratorFactory factory : integrators) {
      for (int k = 4; k <= 8; k += 2) {
        Run run = problem.run(factory, StrictMath.pow(10, -k));
        String which = run.integrator().getClass().getSimpleName() + ", 1e-" + k;
        assertThat(run.result()).as(which).isEqualTo(StepResult.REACHED_END);
        // The bound of the suite: three digits fewer than asked for.
        assertThat(digits(problem, run.atEnd(), reference)).as(which).isGreaterThan(k - 3);
      }
    }
  }

  /** Van der Pol with mu = 1e6 in its own time scale: two jumps that last 1e-12 of the time. */
  private static final FunctionOde SHARP =
      new FunctionOde(
          2,
          (t, y, d) -> {
            d[0] = y[1];
            d[1] = ((1 - y[0] * y[0]) * y[1] - y[0]) * 1e12;
          });

  private static final double[] SHARP_START = {2, -2.0 / 3};

  /**
   * By collocation of orders 9 and 13, with time counted anew before each jump; 14 digits agree.
   */
  private static final double[] SHARP_AT_2 = {1.70554621753508, -0.893476362546847};

  private static double sharpDigits(double[] y) {
    double worst = 0;
    for (int i = 0; i < 2; i++) {
      worst = Math.max(worst, Math.abs(y[i] - SHARP_AT_2[i]) / (1 + Math.abs(SHARP_AT_2[i])));
    }
    return -StrictMath.log10(worst);
  }

  @ParameterizedTest
  @ValueSource(ints = {4, 5, 6, 7, 8, 9, 10, 11, 12, 13})
  void jumpsHardlyLongerThanTheUnitsOfTimeAreFollowedOrRefused(int k) {
    double tolerance = StrictMath.pow(10, -k);
    IntegratorSettings settings = new IntegratorSettings(tolerance, tolerance);
    for (Integrator integrator : List.of(new Ode15s(settings), new Switching(settings))) {
      Run run = Run.of(integrator, SHARP, 0, SHARP_START, 2);
      if (k <= 10) {
        assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
        // As far as with jumps of any length: no floor.
        assertThat(sharpDigits(run.atEnd())).isGreaterThan(k - 1.5);
      } else {
        assertThat(run.result()).isEqualTo(StepResult.FAILED);
        assertThat(integrator.failure().cause()).isEqualTo(Cause.STEP_TOO_SMALL);
      }
    }
  }

  @Test
  void sharpJumpsKeepAllDigitsWithTimeCountedAnewBeforeEach() {
    double[] cuts = {0, 0.8068528427, 0.8068528429, 1.6137056967, 1.6137056974, 2};
    double[] y = SHARP_START;
    for (int i = 1; i < cuts.length; i++) {
      Ode15s integrator = new Ode15s(new IntegratorSettings(1e-13, 1e-13));
      y = Run.of(integrator, SHARP, 0, y, cuts[i] - cuts[i - 1]).atEnd();
    }
    assertThat(sharpDigits(y)).isGreaterThan(11);
  }
}
