package org.mechservice.report.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class ReferenceCodeTest {
  private static final long NO_DEADLINE = Long.MAX_VALUE;

  /** Kepler's problem, eccentricity e; exact by u − e sin u = t. */
  private static Problem kepler() {
    return problem(
        4,
        (t, y, yDot) -> {
          double r3 = Math.pow(y[0] * y[0] + y[1] * y[1], 1.5);
          yDot[0] = y[2];
          yDot[1] = y[3];
          yDot[2] = -y[0] / r3;
          yDot[3] = -y[1] / r3;
        });
  }

  private interface Slope {
    void at(double t, double[] y, double[] yDot);
  }

  private static Problem problem(int n, Slope slope) {
    return new Problem() {
      @Override
      public int dimension() {
        return n;
      }

      @Override
      public boolean derivative(double t, double[] y, double[] yDot) {
        slope.at(t, y, yDot);
        return true;
      }
    };
  }

  private static Stream<ReferenceCode> codes() {
    return Stream.of(new RadauCode(5), new RadauCode(7), new ExtrapolationCode(8));
  }

  private static double[] end(ReferenceCode code, Problem problem, double[] y0, double t1) {
    double tolerance = code instanceof RadauCode ? 1e-12 : 1e-13;
    double[][] states =
        code.solve(problem, new double[] {0, t1 / 2, t1}, y0, tolerance, NO_DEADLINE).orElseThrow();
    return states[2];
  }

  @ParameterizedTest
  @MethodSource("codes")
  void orbitOfHighEccentricityEndsWhereKeplersEquationSays(ReferenceCode code) {
    // Verified to 25 digits in the suite; the orbit amplifies rounding some hundred times.
    double[] exact = {
      -1.295266250987574, 0.4003938963792321, -0.6775390924707566, -0.1270838154278687
    };
    double[] y = end(code, kepler(), new double[] {0.1, 0, 0, Math.sqrt(19)}, 20);
    for (int i = 0; i < 4; i++) {
      assertThat(y[i]).isCloseTo(exact[i], offset(1e-11));
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {5, 7})
  void stiffProblemOfProtheroAndRobinsonStaysOnItsCosine(int stages) {
    Problem stiff = problem(1, (t, y, yDot) -> yDot[0] = -1e6 * (y[0] - Math.cos(t)) - Math.sin(t));
    double[] y = end(new RadauCode(stages), stiff, new double[] {1}, 10);
    // The order falls to that of the stages here, so the tolerance is the error.
    assertThat(y[0]).isCloseTo(Math.cos(10), offset(2e-12));
  }

  @ParameterizedTest
  @ValueSource(ints = {5, 7})
  void relaxationOscillatorAgreesWithItsPublishedEnd(int stages) {
    // Van der Pol, mu = 1000, to t = 2000: the suite's reference, 18 digits.
    Problem stiff =
        problem(
            2,
            (t, y, yDot) -> {
              yDot[0] = y[1];
              yDot[1] = 1000 * (1 - y[0] * y[0]) * y[1] - y[0];
            });
    double[] y = end(new RadauCode(stages), stiff, new double[] {2, 0}, 2000);
    assertThat(y[0]).isCloseTo(1.706167732170465, offset(1e-11));
  }

  /** One step on y' = y is a rational function whose error in h has order 2s for 2s − 1. */
  @ParameterizedTest
  @ValueSource(ints = {2, 3})
  void localErrorOfCollocationHasTheOrderItPromises(int stages) {
    Problem growth = problem(1, (t, y, yDot) -> yDot[0] = y[0]);
    ReferenceCode code = new RadauCode(stages);
    // A tolerance that everything passes makes one step of each interval.
    double[] one = {1};
    double coarse =
        code.solve(growth, new double[] {0, 0.4e-3, 0.4}, one, 1, NO_DEADLINE).orElseThrow()[2][0]
            - Math.exp(0.4);
    double fine =
        code.solve(growth, new double[] {0, 0.2e-3, 0.2}, one, 1, NO_DEADLINE).orElseThrow()[2][0]
            - Math.exp(0.2);
    double order = Math.log(coarse / fine) / Math.log(2);
    assertThat(order).isBetween(2 * stages - 0.5, 2 * stages + 0.7);
  }

  /** Extrapolated k times, the midpoint rule has order 2k. */
  @ParameterizedTest
  @ValueSource(ints = {2, 3})
  void localErrorOfExtrapolationHasTheOrderItPromises(int columns) {
    Problem growth = problem(1, (t, y, yDot) -> yDot[0] = y[0]);
    ReferenceCode code = new ExtrapolationCode(columns);
    double[] error = new double[2];
    for (int i = 0; i < 2; i++) {
      double h = 0.4 / (1 << i);
      double[] times = {0, h * 1e-3, h};
      double[] one = {1};
      error[i] = code.solve(growth, times, one, 1, NO_DEADLINE).orElseThrow()[2][0] - Math.exp(h);
    }
    double order = Math.log(error[0] / error[1]) / Math.log(2);
    assertThat(order).isBetween(2 * columns + 0.5, 2 * columns + 1.5);
  }
}
