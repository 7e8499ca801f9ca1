package org.mechservice.solver.ode.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** M y' = f(t, y) with a constant M. */
class MassProblemTest {
  /** M y' = −K y with the solution y = (e^{−t}, e^{−2t}): K = M diag(1, 2). */
  private static OdeProblem decay(double[][] m) {
    return Ode.system(
        2,
        (t, y, yDot) -> {
          for (int i = 0; i < 2; i++) {
            yDot[i] = -m[i][0] * y[0] - 2 * m[i][1] * y[1];
          }
        });
  }

  private static final double[][] FULL = {{2, 1}, {1, 3}};
  private static final double[][] DIAGONAL = {{2, 0}, {0, 5}};

  private static void assertDecays(MassProblem problem, OdeOptions options) {
    OdeSolution solution = Ode.solve(problem, 0, new double[] {1, 1}, 2, options);
    for (double t = 0; t <= 2; t += 0.25) {
      assertThat(solution.at(t)[0]).isCloseTo(StrictMath.exp(-t), within(1e-5));
      assertThat(solution.at(t)[1]).isCloseTo(StrictMath.exp(-2 * t), within(1e-5));
    }
  }

  @ParameterizedTest
  @EnumSource
  void regularMatrixIsTakenByEveryMethodInEveryStorage(OdeMethod method) {
    OdeOptions options = OdeOptions.standard().rtol(1e-7).method(method);
    assertDecays(decay(FULL).withMass(MassMatrix.full(FULL)), options);
    assertDecays(decay(FULL).withMass(MassMatrix.banded(2, 1, 1, 0, 2, 1, 1, 3, 0)), options);
    assertDecays(decay(DIAGONAL).withMass(MassMatrix.diagonal(2, 5)), options);
  }

  @ParameterizedTest
  @EnumSource
  void analyticJacobianOfTheFunctionIsUsedWithEveryMatrix(OdeMethod method) {
    OdeOptions options = OdeOptions.standard().rtol(1e-7).method(method);
    for (double[][] m : new double[][][] {FULL, DIAGONAL}) {
      OdeProblem known =
          decay(m)
              .withJacobian(
                  (t, y, fy) -> {
                    fy[0] = -m[0][0];
                    fy[1] = -2 * m[0][1];
                    fy[2] = -m[1][0];
                    fy[3] = -2 * m[1][1];
                  });
      boolean diagonal = m == DIAGONAL;
      assertDecays(
          known.withMass(diagonal ? MassMatrix.diagonal(2, 5) : MassMatrix.full(m)), options);
      if (diagonal) {
        assertDecays(known.withMass(MassMatrix.full(m)), options);
      }
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"AUTO", "ODE15S", "ODE15SR"})
  void zeroOnTheDiagonalMakesAComponentAlgebraic(OdeMethod method) {
    // y0' = −y0 + y1, 0 = y1 − 2 y0: y0 = e^t. The guess of y1 is wrong.
    MassProblem problem =
        Ode.system(
                2,
                (t, y, yDot) -> {
                  yDot[0] = y[1] - y[0];
                  yDot[1] = y[1] - 2 * y[0];
                })
            .withMass(MassMatrix.diagonal(1, 0));
    OdeSolution solution =
        Ode.solve(
            problem, 0, new double[] {1, 0}, 1, OdeOptions.standard().rtol(1e-8).method(method));
    assertThat(solution.startState()[1]).isCloseTo(2, within(1e-10));
    assertThat(solution.at(0.5)[0]).isCloseTo(StrictMath.exp(0.5), within(1e-6));
    assertThat(solution.endState()[1]).isCloseTo(2 * Math.E, within(1e-5));
  }

  @ParameterizedTest
  @EnumSource(names = {"ODE113", "DE"})
  void singularMatrixIsRefusedByExplicitMethods(OdeMethod method) {
    OdeOptions options = OdeOptions.standard().method(method);
    for (MassMatrix m :
        new MassMatrix[] {
          MassMatrix.diagonal(1, 0), MassMatrix.full(new double[][] {{1, 2}, {2, 4}})
        }) {
      assertThatIllegalArgumentException()
          .isThrownBy(() -> Ode.solve(decay(FULL).withMass(m), 0, new double[] {1, 1}, 1, options))
          .withMessageContaining("mass matrix is singular")
          .withMessageContaining("ODE15SR or AUTO");
    }
  }

  @Test
  void bandsOfMatrixAndFunctionTogetherSaveEvaluations() {
    // Linear finite elements for heat conduction: M tridiagonal with 4/6 and 1/6.
    int n = 60;
    OdeProblem heat =
        Ode.system(
            n,
            (t, y, yDot) -> {
              for (int i = 0; i < n; i++) {
                double left = i == 0 ? 0 : y[i - 1];
                double right = i == n - 1 ? 0 : y[i + 1];
                yDot[i] = 100 * (left - 2 * y[i] + right);
              }
            });
    double[] band = new double[3 * n];
    for (int i = 0; i < n; i++) {
      band[3 * i] = 1.0 / 6;
      band[3 * i + 1] = 4.0 / 6;
      band[3 * i + 2] = 1.0 / 6;
    }
    MassMatrix mass = MassMatrix.banded(n, 1, 1, band);
    double[] y0 = new double[n];
    Arrays.fill(y0, 1);
    OdeSolution full = Ode.solve(heat.withMass(mass), 0, y0, 1);
    OdeSolution banded = Ode.solve(heat.withBand(1, 1).withMass(mass), 0, y0, 1);
    OdeSolution product =
        Ode.solve(
            heat.withBand(1, 1)
                .withJacobianProduct(
                    (t, y, v, out) -> {
                      for (int i = 0; i < n; i++) {
                        double left = i == 0 ? 0 : v[i - 1];
                        double right = i == n - 1 ? 0 : v[i + 1];
                        out[i] = 100 * (left - 2 * v[i] + right);
                      }
                    })
                .withMass(mass),
            0,
            y0,
            1);
    assertThat(banded.statistics().evaluations()).isLessThan(full.statistics().evaluations());
    assertThat(product.statistics().evaluations()).isLessThan(banded.statistics().evaluations());
    assertThat(banded.endState()[30]).isCloseTo(full.endState()[30], within(1e-6));
    assertThat(product.endState()[30]).isCloseTo(full.endState()[30], within(1e-6));
  }

  @ParameterizedTest
  @EnumSource
  void wrappedFunctionKeepsItsMatrix(OdeMethod method) {
    long[] count = {0};
    MassProblem problem =
        decay(DIAGONAL)
            .withMass(MassMatrix.diagonal(2, 5))
            .withFunction(
                f ->
                    (t, y, yDot) -> {
                      count[0]++;
                      f.evaluate(t, y, yDot);
                    });
    OdeSolution solution =
        Ode.solve(problem, 0, new double[] {1, 1}, 1, OdeOptions.standard().method(method));
    // One more gives the slope at the start.
    assertThat(count[0]).isEqualTo(solution.statistics().evaluations() + 1);
    assertThat(solution.endState()[0]).isCloseTo(1 / Math.E, within(1e-4));
  }

  @Test
  void badMatricesAreRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> MassMatrix.full(new double[][] {{1, 2}, {3}}))
        .withMessageContaining("row 1 of the mass matrix has 1 elements");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> MassMatrix.diagonal(1, Double.NaN))
        .withMessageContaining("element (1, 1) of the mass matrix is NaN");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> MassMatrix.banded(3, 1, 1, 1, 2))
        .withMessageContaining("has 2 elements; it must have 9");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> decay(FULL).withMass(MassMatrix.diagonal(1, 1, 1)))
        .withMessageContaining("mass matrix has 3 rows; it must have 2");
  }
}
