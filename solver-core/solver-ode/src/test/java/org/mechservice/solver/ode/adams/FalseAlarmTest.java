package org.mechservice.solver.ode.adams;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.suite.Arenstorf;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.FunctionOde.Equation;
import org.mechservice.solver.ode.suite.Run;

/**
 * Problems whose fastest motion is the one that the tolerance wants followed are never called
 * stiff: oscillations, decays that end within some time constants, chaos, forced motions, orbits,
 * growth, runs of a few steps.
 *
 * <p>Not among them is Roessler's band, contracted 5 to 14 times faster than it turns: stability
 * does limit the steps on it, all along, and ode15s ends it in nine tenths of the evaluations at
 * 1e-3. It is suspected, as a decay followed for 20 time constants is at tight tolerances.
 */
class FalseAlarmTest {
  /** A problem that is not stiff. */
  @SuppressWarnings("ArrayRecordComponent") // compared by nobody
  record Problem(String name, Equation equation, double end, double... start) {
    FunctionOde ode() {
      return new FunctionOde(start.length, equation);
    }
  }

  /** x'' = g(t, x, x'), one coordinate. */
  private interface Acceleration {
    double at(double t, double x, double v);
  }

  private static Problem motion(
      String name, double end, double x, double v, Acceleration acceleration) {
    return new Problem(
        name,
        (t, y, yDot) -> {
          yDot[0] = y[1];
          yDot[1] = acceleration.at(t, y[0], y[1]);
        },
        end,
        x,
        v);
  }

  private static Problem single(String name, double end, double y0, Single f) {
    return new Problem(name, (t, y, yDot) -> yDot[0] = f.at(t, y[0]), end, y0);
  }

  /** One equation y' = f(t, y). */
  private interface Single {
    double at(double t, double y);
  }

  static final List<Problem> PROBLEMS =
      List.of(
          // Undamped and lightly damped oscillations
          motion("oscillator", 50, 1, 0, (t, x, v) -> -x),
          motion("fast oscillator", 0.2, 1, 0, (t, x, v) -> -1e6 * x),
          motion("damped 0.1 %", 50, 1, 0, (t, x, v) -> -0.002 * v - x),
          motion("damped 1 %", 50, 1, 0, (t, x, v) -> -0.02 * v - x),
          motion("damped 5 %", 30, 1, 0, (t, x, v) -> -0.1 * v - x),
          motion("damped 20 %", 15, 1, 0, (t, x, v) -> -0.4 * v - x),
          motion("pendulum", 30, 1, 0, (t, x, v) -> -9.81 * StrictMath.sin(x)),
          motion("pendulum near the top", 20, 3.1, 0, (t, x, v) -> -StrictMath.sin(x)),
          motion("rotating pendulum", 10, 0, 10, (t, x, v) -> -9.81 * StrictMath.sin(x)),
          motion("hardening spring", 20, 3, 0, (t, x, v) -> -x - x * x * x),
          motion("quintic spring", 20, 2, 0, (t, x, v) -> -StrictMath.pow(x, 5)),
          motion("two wells", 30, 1.5, 0, (t, x, v) -> x - x * x * x),
          motion("friction of turbulence", 30, 2, 0, (t, x, v) -> -0.1 * v * Math.abs(v) - x),
          motion("Van der Pol, 0.1", 40, 1, 0, (t, x, v) -> 0.1 * (1 - x * x) * v - x),
          motion("Van der Pol, 1", 30, 2, 0, (t, x, v) -> (1 - x * x) * v - x),
          new Problem("two frequencies", FalseAlarmTest::twoFrequencies, 20, 1, 0, 1, 0),
          new Problem("ten masses", FalseAlarmTest::masses, 20, masses()),
          new Problem("rotation", FalseAlarmTest::rotation, 10, 1, 0),
          motion("Mathieu", 40, 1, 0, (t, x, v) -> -(1 + 0.2 * StrictMath.cos(2 * t)) * x),
          motion("Airy", 15, 1, 0, (t, x, v) -> -t * x),
          motion("Bessel", 30, 1, 0, (t, x, v) -> -v / (t + 1) - x),
          // Decays that end within some time constants
          single("decay", 5, 1, (t, y) -> -y),
          single("fast decay", 5e-4, 1, (t, y) -> -1e4 * y),
          new Problem("two decays", FalseAlarmTest::decays, 4, 1, 1),
          new Problem("DETEST B4", FalseAlarmTest::circle, 20, 3, 0, 0),
          new Problem("radioactive chain", FalseAlarmTest::chain, 10, 1, 0, 0, 0, 0),
          single("cubic decay", 20, 1, (t, y) -> -0.5 * y * y * y),
          single("logistic", 20, 0.01, (t, y) -> 0.25 * y * (1 - y / 20)),
          single("cooling with the day", 20, 1, (t, y) -> -0.1 * (y - StrictMath.cos(t))),
          motion("critical damping", 6, 1, 0, (t, x, v) -> -2 * v - x),
          new Problem("reaction in steps", FalseAlarmTest::reaction, 3, 2, 0, 1),
          // Chaos
          new Problem("Lorenz", FalseAlarmTest::lorenz, 10, 1, 1, 1),
          new Problem("Arenstorf", new Arenstorf()::derivative, 17, arenstorf()),
          new Problem("Henon and Heiles", FalseAlarmTest::henonHeiles, 60, 0, 0.1, 0.5, 0),
          motion(
              "Duffing",
              40,
              1,
              0,
              (t, x, v) -> -0.15 * v + x - x * x * x + 0.3 * StrictMath.cos(t)),
          motion(
              "driven pendulum",
              40,
              0.2,
              0,
              (t, x, v) -> -0.5 * v - StrictMath.sin(x) + 1.15 * StrictMath.cos(2 * t / 3)),
          new Problem("double pendulum", FalseAlarmTest::doublePendulum, 10, 2, 2.5, 0, 0),
          // Forced motions
          motion("forced", 30, 0, 0, (t, x, v) -> StrictMath.cos(2 * t) - x),
          motion("resonance", 30, 0, 0, (t, x, v) -> StrictMath.cos(t) - x),
          motion("forced, damped 5 %", 30, 0, 0, (t, x, v) -> StrictMath.cos(t) - 0.1 * v - x),
          motion("swept", 20, 0, 0, (t, x, v) -> StrictMath.sin(0.2 * t * t) - 0.1 * v - x),
          single("quadrature", 20, 0, (t, y) -> StrictMath.cos(t)),
          single("rational", 20, 0, (t, y) -> 1 / (1 + (t - 10) * (t - 10))),
          single("pulse", 10, 0, (t, y) -> StrictMath.exp(-20 * (t - 5) * (t - 5))),
          // Orbits
          new Problem("circle", FalseAlarmTest::kepler, 30, 1, 0, 0, 1),
          new Problem("Kepler, e = 0.5", FalseAlarmTest::kepler, 20, 0.5, 0, 0, Math.sqrt(3)),
          new Problem("Kepler, e = 0.9", FalseAlarmTest::kepler, 20, 0.1, 0, 0, Math.sqrt(19)),
          new Problem("fly-by", FalseAlarmTest::kepler, 10, -5, 0.3, 1, 0),
          new Problem("charge", FalseAlarmTest::charge, 20, 0, 0, 0, 1, 0, 0.5),
          new Problem("top", FalseAlarmTest::top, 30, 1, 0.01, 0.1),
          // Populations
          new Problem("Lotka and Volterra", FalseAlarmTest::lotkaVolterra, 20, 3, 1),
          new Problem("epidemic", FalseAlarmTest::epidemic, 40, 0.99, 0.01),
          new Problem("Brusselator in a point", FalseAlarmTest::brusselator, 20, 1.5, 3),
          // Growth
          single("power", 10, 0, (t, y) -> 9 * StrictMath.pow(t, 8)),
          single("straight", 100, 0, (t, y) -> 1),
          single("growth", 20, 1, (t, y) -> y),
          single("root", 100, 1, (t, y) -> Math.sqrt(y)),
          single("spiral", 20, 1, (t, y) -> y * StrictMath.cos(t)),
          motion("thrown", 10, 0, 20, (t, x, v) -> -9.81),
          motion("fall with drag", 2, 100, 0, (t, x, v) -> -9.81 - 0.01 * v * Math.abs(v)),
          // Runs of a few steps
          motion("short oscillation", 1e-3, 1, 0, (t, x, v) -> -x),
          single("short decay", 1e-6, 1, (t, y) -> -1e3 * y),
          new Problem("short Lorenz", FalseAlarmTest::lorenz, 1e-3, 1, 1, 1),
          single("at rest", 1, 0, (t, y) -> -y));

  private static void twoFrequencies(double t, double[] y, double[] yDot) {
    yDot[0] = y[1];
    yDot[1] = -y[0] + 0.1 * y[2];
    yDot[2] = y[3];
    yDot[3] = -100 * y[2] + 0.1 * y[0];
  }

  /** Ten masses in a row, started by the first; springs of 10, lightly damped. */
  private static void masses(double t, double[] y, double[] yDot) {
    for (int i = 0; i < 10; i++) {
      double left = i == 0 ? 0 : y[i - 1];
      double right = i == 9 ? 0 : y[i + 1];
      yDot[i] = y[10 + i];
      yDot[10 + i] = 10 * (left - 2 * y[i] + right) - 0.01 * y[10 + i];
    }
  }

  private static double[] masses() {
    double[] y = new double[20];
    y[0] = 1;
    return y;
  }

  private static void rotation(double t, double[] y, double[] yDot) {
    yDot[0] = -0.1 * y[0] + 20 * y[1];
    yDot[1] = -20 * y[0] - 0.1 * y[1];
  }

  private static void decays(double t, double[] y, double[] yDot) {
    yDot[0] = -y[0];
    yDot[1] = -2 * y[1];
  }

  /** Hull and others, 1972, B4. */
  private static void circle(double t, double[] y, double[] yDot) {
    double r = Math.sqrt(y[0] * y[0] + y[1] * y[1]);
    yDot[0] = -y[1] - y[0] * y[2] / r;
    yDot[1] = y[0] - y[1] * y[2] / r;
    yDot[2] = y[0] / r;
  }

  private static void chain(double t, double[] y, double[] yDot) {
    yDot[0] = -y[0];
    for (int i = 1; i < 4; i++) {
      yDot[i] = y[i - 1] - y[i];
    }
    yDot[4] = y[3];
  }

  private static void reaction(double t, double[] y, double[] yDot) {
    yDot[0] = -y[0] + y[1];
    yDot[1] = y[0] - 2 * y[1] + y[2];
    yDot[2] = y[1] - y[2];
  }

  private static void lorenz(double t, double[] y, double[] yDot) {
    yDot[0] = 10 * (y[1] - y[0]);
    yDot[1] = y[0] * (28 - y[2]) - y[1];
    yDot[2] = y[0] * y[1] - 8.0 / 3 * y[2];
  }

  private static double[] arenstorf() {
    return new Arenstorf().reference().initialState();
  }

  private static void henonHeiles(double t, double[] y, double[] yDot) {
    yDot[0] = y[2];
    yDot[1] = y[3];
    yDot[2] = -y[0] - 2 * y[0] * y[1];
    yDot[3] = -y[1] - y[0] * y[0] + y[1] * y[1];
  }

  /** Two rods of length and mass 1, by angles from the vertical. */
  private static void doublePendulum(double t, double[] y, double[] yDot) {
    double c = StrictMath.cos(y[0] - y[1]);
    double s = StrictMath.sin(y[0] - y[1]);
    double g = 9.81;
    double first = -s * y[3] * y[3] - 2 * g * StrictMath.sin(y[0]);
    double second = s * y[2] * y[2] - g * StrictMath.sin(y[1]);
    yDot[0] = y[2];
    yDot[1] = y[3];
    yDot[2] = (first - c * second) / (2 - c * c);
    yDot[3] = (2 * second - c * first) / (2 - c * c);
  }

  private static void kepler(double t, double[] y, double[] yDot) {
    double r = Math.sqrt(y[0] * y[0] + y[1] * y[1]);
    yDot[0] = y[2];
    yDot[1] = y[3];
    yDot[2] = -y[0] / (r * r * r);
    yDot[3] = -y[1] / (r * r * r);
  }

  /** A charge in a magnetic field that grows along x. */
  private static void charge(double t, double[] y, double[] yDot) {
    double field = 2 + 0.5 * y[0];
    yDot[0] = y[3];
    yDot[1] = y[4];
    yDot[2] = y[5];
    yDot[3] = field * y[4];
    yDot[4] = -field * y[3];
    yDot[5] = 0;
  }

  /** A free body that tumbles about its middle axis. */
  private static void top(double t, double[] y, double[] yDot) {
    yDot[0] = -y[1] * y[2];
    yDot[1] = y[2] * y[0];
    yDot[2] = -0.51 * y[0] * y[1];
  }

  private static void lotkaVolterra(double t, double[] y, double[] yDot) {
    yDot[0] = y[0] * (2 - y[1]);
    yDot[1] = y[1] * (y[0] - 1);
  }

  private static void epidemic(double t, double[] y, double[] yDot) {
    double caught = 1.5 * y[0] * y[1];
    yDot[0] = -caught;
    yDot[1] = caught - 0.3 * y[1];
  }

  private static void brusselator(double t, double[] y, double[] yDot) {
    yDot[0] = 1 + y[0] * y[0] * y[1] - 4 * y[0];
    yDot[1] = 3 * y[0] - y[0] * y[0] * y[1];
  }

  static List<String> alarms(double tolerance) {
    List<String> alarms = new ArrayList<>();
    IntegratorSettings settings = new IntegratorSettings(tolerance, tolerance);
    for (Problem problem : PROBLEMS) {
      for (Integrator integrator : List.of(new Ode113(settings), new De(settings))) {
        Run run = Run.of(integrator, problem.ode(), 0, problem.start(), problem.end());
        if (run.statistics().stiffnessSuspected()) {
          alarms.add(integrator.getClass().getSimpleName() + " on " + problem.name());
        }
      }
    }
    return alarms;
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-11})
  void problemsThatAreNotStiffAreNotCalledSo(double tolerance) {
    assertThat(alarms(tolerance)).isEmpty();
  }
}
