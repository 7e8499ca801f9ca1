package org.mechservice.solver.ode.stiff;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.ImplicitOde;
import org.mechservice.solver.ode.suite.Run;

/**
 * Differential-algebraic and implicit problems that are not in the suite, each with the explicit
 * problem that it amounts to: another formulation, integrated by another method, Adams at 1e-12,
 * says what is right.
 */
class FurtherResidualProblemsTest {
  /** Takes the unknowns of the residual form from those of the explicit one. */
  private interface Unknowns {
    double[] of(double t, double[] explicit);
  }

  /**
   * @param algebraic index of the first algebraic component, all others follow
   */
  private record Problem(
      String name,
      double end,
      FunctionOde explicit,
      List<Double> start,
      int algebraic,
      Unknowns unknowns,
      ImplicitOde.Equation residual) {
    double[] reference() {
      IntegratorSettings settings = new IntegratorSettings(1e-12, 1e-12);
      double[] y0 = start.stream().mapToDouble(Double::doubleValue).toArray();
      return unknowns.of(end, Run.of(new Ode113(settings), explicit, 0, y0, end).atEnd());
    }

    double[] initialState() {
      return unknowns.of(0, start.stream().mapToDouble(Double::doubleValue).toArray());
    }

    @Override
    public String toString() {
      return name;
    }
  }

  /** A problem whose last components are algebraic. */
  private static final class Mixed extends ImplicitOde {
    private final int algebraic;

    Mixed(int dimension, int algebraic, Equation equation) {
      super(dimension, equation);
      this.algebraic = algebraic;
    }

    @Override
    public Component component(int index) {
      return index < algebraic ? Component.DIFFERENTIAL : Component.ALGEBRAIC;
    }
  }

  private static final double GRAVITY = 9.81;
  private static final double SATURATION = 1e-6;
  private static final double THERMAL = 0.026;

  private static double source(double t) {
    return StrictMath.sin(2 * Math.PI * t);
  }

  static Stream<Problem> problems() {
    return Stream.of(
        // Acceleration form of index 1 with a multiplier, beside the angle from the downward axis.
        new Problem(
            "pendulum",
            3,
            new FunctionOde(
                2,
                (t, y, d) -> {
                  d[0] = y[1];
                  d[1] = -GRAVITY * StrictMath.sin(y[0]);
                }),
            List.of(1.5, 0.0),
            4,
            (t, y) -> {
              double sin = StrictMath.sin(y[0]);
              double cos = StrictMath.cos(y[0]);
              double multiplier = y[1] * y[1] + GRAVITY * cos;
              return new double[] {sin, -cos, y[1] * cos, y[1] * sin, multiplier};
            },
            (t, y, d, r) -> {
              r[0] = d[0] - y[2];
              r[1] = d[1] - y[3];
              r[2] = d[2] + y[4] * y[0];
              r[3] = d[3] + y[4] * y[1] + GRAVITY;
              r[4] =
                  y[2] * y[2] + y[3] * y[3] - y[4] * (y[0] * y[0] + y[1] * y[1]) - GRAVITY * y[1];
            }),
        // z + z^3 = y in equilibrium; explicitly, z' = y' / (1 + 3 z^2).
        new Problem(
            "equilibrium",
            5,
            new FunctionOde(
                2,
                (t, y, d) -> {
                  d[0] = StrictMath.cos(3 * t) - y[1];
                  d[1] = d[0] / (1 + 3 * y[1] * y[1]);
                }),
            List.of(2.0, 1.0),
            1,
            (t, y) -> y.clone(),
            (t, y, d, r) -> {
              r[0] = d[0] + y[1] - StrictMath.cos(3 * t);
              r[1] = y[1] + y[1] * y[1] * y[1] - y[0];
            }),
        // A rectifier: the voltage across the diode is algebraic; explicitly it is sin - u.
        new Problem(
            "rectifier",
            2,
            new FunctionOde(
                1,
                (t, y, d) ->
                    d[0] =
                        1e3 * SATURATION * (StrictMath.exp((source(t) - y[0]) / THERMAL) - 1)
                            - 10 * y[0]),
            List.of(0.0),
            1,
            (t, y) -> new double[] {y[0], source(t) - y[0]},
            (t, y, d, r) -> {
              double current = SATURATION * (StrictMath.exp(y[1] / THERMAL) - 1);
              r[0] = d[0] - 1e3 * current + 10 * y[0];
              r[1] = y[0] + y[1] - source(t);
            }),
        // A mass that moves with the state: (1 + x^2) x'' + x x'^2 + x = 0, a bead on a wire.
        new Problem(
            "bead",
            10,
            new FunctionOde(
                2,
                (t, y, d) -> {
                  d[0] = y[1];
                  d[1] = -(y[0] * y[1] * y[1] + y[0]) / (1 + y[0] * y[0]);
                }),
            List.of(1.0, 0.5),
            2,
            (t, y) -> y.clone(),
            (t, y, d, r) -> {
              r[0] = d[0] - y[1];
              r[1] = (1 + y[0] * y[0]) * d[1] + y[0] * y[1] * y[1] + y[0];
            }));
  }

  @ParameterizedTest
  @MethodSource("problems")
  void residualFormAgreesWithTheExplicitProblemItAmountsTo(Problem problem) {
    double[] reference = problem.reference();
    double[] y0 = problem.initialState();
    Mixed mixed = new Mixed(y0.length, problem.algebraic(), problem.residual());
    for (int k = 4; k <= 10; k += 2) {
      double tolerance = StrictMath.pow(10, -k);
      Ode15sR integrator = new Ode15sR(new IntegratorSettings(tolerance, tolerance));
      StepResult result = integrator.start(mixed, 0, y0, new double[y0.length], problem.end());
      while (result == StepResult.ADVANCED) {
        result = integrator.step();
      }
      assertThat(result).isEqualTo(StepResult.REACHED_END);
      double[] y = Run.state(integrator, problem.end(), y0.length);
      // The bound of the suite, three digits fewer than asked for; multipliers and currents too.
      assertThat(digits(y, reference)).as("1e-" + k).isGreaterThan(k - 3);
    }
  }

  private static double digits(double[] y, double[] reference) {
    double[] errors = new double[y.length];
    Arrays.setAll(errors, i -> Math.abs(y[i] - reference[i]) / (1 + Math.abs(reference[i])));
    return -StrictMath.log10(Arrays.stream(errors).max().orElseThrow());
  }
}
