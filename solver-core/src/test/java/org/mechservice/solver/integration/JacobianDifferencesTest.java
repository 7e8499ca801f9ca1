package org.mechservice.solver.integration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.mechservice.solver.integration.suite.Brusselator;
import org.mechservice.solver.linear.BandLayout;
import org.mechservice.solver.linear.DenseLayout;
import org.mechservice.solver.linear.MatrixLayout;

class JacobianDifferencesTest {
  private static double[] evaluate(Ode ode, double[] threshold, double[] y) {
    MatrixLayout layout = new DenseLayout(y.length);
    double[] fy = new double[layout.length()];
    Attempt attempt =
        new JacobianDifferences(layout, threshold)
            .evaluate(new RightHandSide(ode, () -> false), 0, y, fy);
    assertThat(attempt).isEqualTo(Attempt.PASSED);
    return fy;
  }

  @Test
  void isTheMatrixOfALinearSystem() {
    Ode linear =
        new Ode(
            2,
            (t, y, yDot) -> {
              yDot[0] = 3 * y[0] - 1e6 * y[1];
              yDot[1] = 1e-3 * y[0];
            });
    double[] fy = evaluate(linear, new double[] {1, 1}, new double[] {1, 2});
    // Half the digits of f, here of 2e6 for the elements of row 0.
    assertThat(fy[0]).isCloseTo(3, within(0.1));
    assertThat(fy[1]).isCloseTo(-1e6, within(1.0));
    assertThat(fy[2]).isCloseTo(1e-3, within(1e-10));
    assertThat(fy[3]).isZero();
  }

  @Test
  void isGoodToHalfTheDigitsOfANonlinearOne() {
    Ode product = new Ode(1, (t, y, yDot) -> yDot[0] = y[0] * y[0] * y[0]);
    double[] fy = evaluate(product, new double[] {1e-3}, new double[] {2});
    assertThat(fy[0]).isCloseTo(12, within(1e-6));
  }

  @Test
  void changeLostInRoundOffIsDifferencedAgainOverMore() {
    // √u of the threshold changes f by 1.5e-20 of its value; u^(1/4) of it by 1.2e-16, so twice.
    Ode offset = new Ode(1, (t, y, yDot) -> yDot[0] = 1e9 + y[0]);
    double[] fy = new double[1];
    JacobianDifferences differences =
        new JacobianDifferences(new DenseLayout(1), new double[] {1e-3});
    RightHandSide equations = new RightHandSide(offset, () -> false);
    for (int i = 0; i < 4; i++) {
      differences.evaluate(equations, 0, new double[] {0}, fy);
    }
    // At the largest share, a tenth of the threshold, f has 1e-7 of round-off on 1e-4.
    assertThat(fy[0]).isCloseTo(1, within(2e-3));
    // Two per Jacobian and one repetition as long as the share can grow.
    assertThat(equations.evaluations()).isBetween(10L, 11L);
  }

  @Test
  void pointMovedOutOfTheDomainIsMovedTheOtherWay() {
    Ode root = new Ode(1, (t, y, yDot) -> yDot[0] = 2 + Math.sqrt(1 - y[0]) * (1 - y[0]));
    double[] fy = evaluate(root, new double[] {1}, new double[] {1});
    assertThat(fy[0]).isCloseTo(0, within(1e-3));
  }

  @Test
  void componentNotFiniteOnBothSidesIsNamed() {
    Ode needle =
        new Ode(
            2,
            (t, y, yDot) -> {
              yDot[0] = 0;
              yDot[1] = y[0] == 1 ? 0 : Double.NaN;
            });
    JacobianDifferences differences =
        new JacobianDifferences(new DenseLayout(2), new double[] {1, 1});
    Attempt attempt =
        differences.evaluate(
            new RightHandSide(needle, () -> false), 0, new double[] {1, 1}, new double[4]);
    assertThat(attempt).isEqualTo(Attempt.NOT_FINITE);
    assertThat(differences.notFiniteComponent()).isEqualTo(1);
  }

  @Test
  void bandHasTheElementsOfTheFullMatrix() {
    Brusselator brusselator = new Brusselator();
    double[] y = brusselator.reference().atCheckpoint();
    double[] threshold = brusselator.reference().scale();
    MatrixLayout dense = new DenseLayout(40);
    MatrixLayout band = new BandLayout(40, 2, 2);
    double[] full = new double[dense.length()];
    double[] narrow = new double[band.length()];
    RightHandSide equations = new RightHandSide(brusselator, () -> false);
    new JacobianDifferences(dense, threshold).evaluate(equations, 0, y, full);
    new JacobianDifferences(band, threshold).evaluate(equations, 0, y, narrow);
    for (int j = 0; j < 40; j++) {
      for (int i = band.firstRow(j); i <= band.lastRow(j); i++) {
        assertThat(narrow[band.index(i, j)]).isEqualTo(full[dense.index(i, j)]);
      }
    }
    assertThat(equations.evaluations()).isEqualTo(1 + 40 + 1 + 5);
  }
}
