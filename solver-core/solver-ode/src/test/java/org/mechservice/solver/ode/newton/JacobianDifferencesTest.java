package org.mechservice.solver.ode.newton;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.linear.BandLayout;
import org.mechservice.solver.linear.DenseLayout;
import org.mechservice.solver.linear.MatrixLayout;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.suite.Brusselator;
import org.mechservice.solver.ode.suite.FunctionOde;

class JacobianDifferencesTest {
  private static double[] evaluate(FunctionOde ode, double[] threshold, double[] y) {
    MatrixLayout layout = new DenseLayout(y.length);
    double[] fy = new double[layout.length()];
    TrialOutcome attempt = form(differences(layout, threshold), at0(ode), y, fy);
    assertThat(attempt).isEqualTo(TrialOutcome.PASSED);
    return fy;
  }

  private static JacobianDifferences differences(MatrixLayout layout, double[] threshold) {
    OdeSystem any = new FunctionOde(threshold.length, (t, y, yDot) -> {});
    ColumnGroups groups = ColumnGroups.of(any, layout);
    return new JacobianDifferences(layout, groups, threshold, new Manifold(any));
  }

  private static DifferencedFunction at0(OdeSystem ode) {
    return (y, value) -> {
      ode.derivative(0, y, value);
      return true;
    };
  }

  private static TrialOutcome form(
      JacobianDifferences differences, DifferencedFunction function, double[] y, double[] fy) {
    return differences.evaluate(function, y, differences.value(), fy);
  }

  @Test
  void isTheMatrixOfALinearSystem() {
    FunctionOde linear =
        new FunctionOde(
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
    FunctionOde product = new FunctionOde(1, (t, y, yDot) -> yDot[0] = y[0] * y[0] * y[0]);
    double[] fy = evaluate(product, new double[] {1e-3}, new double[] {2});
    assertThat(fy[0]).isCloseTo(12, within(1e-6));
  }

  @Test
  void changeLostInRoundOffIsDifferencedAgainOverMore() {
    // √u of the threshold changes f by 1.5e-20 of its value; u^(1/4) of it by 1.2e-16, so twice.
    FunctionOde offset = new FunctionOde(1, (t, y, yDot) -> yDot[0] = 1e9 + y[0]);
    double[] fy = new double[1];
    JacobianDifferences differences = differences(new DenseLayout(1), new double[] {1e-3});
    AtomicInteger evaluations = new AtomicInteger();
    for (int i = 0; i < 4; i++) {
      form(differences, counted(at0(offset), evaluations), new double[] {0}, fy);
    }
    // At the largest share, a tenth of the threshold, f has 1e-7 of round-off on 1e-4.
    assertThat(fy[0]).isCloseTo(1, within(2e-3));
    // Two per Jacobian and one repetition as long as the share can grow.
    assertThat(evaluations.get()).isBetween(10, 11);
  }

  private static DifferencedFunction counted(DifferencedFunction function, AtomicInteger count) {
    return (x, value) -> {
      count.incrementAndGet();
      return function.evaluate(x, value);
    };
  }

  @Test
  void smallSumOfLargeTermsIsDifferencedByTheSizeOfTheTerms() {
    // F = 1e8 (x − 1) vanishes at x = 1: judged by F alone every change would look too large.
    DifferencedFunction balance =
        (x, value) -> {
          value[0] = 1e8 * x[0] - 1e8;
          return true;
        };
    OdeSystem any = new FunctionOde(1, (t, y, yDot) -> {});
    MatrixLayout layout = new DenseLayout(1);
    JacobianDifferences differences =
        new JacobianDifferences(
            layout,
            ColumnGroups.of(any, layout),
            new double[] {1},
            new Manifold(any),
            1e-8,
            JacobianDifferences.SMALLEST_SHARE);
    double[] derivative = new double[1];
    for (int i = 0; i < 10; i++) {
      form(differences, balance, new double[] {1}, derivative);
      differences.knowMagnitude(new double[] {1e8});
    }
    // Round-off of the terms, 1.5e-8, over the change, 1.
    assertThat(derivative[0]).isCloseTo(1e8, within(5.0));
  }

  /** Calm, no term is larger than a change, which says nothing about what comes. */
  @Test
  void shareOfAStraightLineStaysWhereAllTermsAreSmall() {
    double[] force = {0};
    DifferencedFunction balance =
        (x, value) -> {
          value[0] = x[0] + force[0];
          return true;
        };
    OdeSystem any = new FunctionOde(1, (t, y, yDot) -> {});
    MatrixLayout layout = new DenseLayout(1);
    JacobianDifferences differences =
        new JacobianDifferences(
            layout,
            ColumnGroups.of(any, layout),
            new double[] {1e-4},
            new Manifold(any),
            0x1p-17,
            0x1p-17);
    double[] derivative = new double[1];
    for (int i = 0; i < 20; i++) {
      differences.knowMagnitude(new double[] {1e-30});
      form(differences, balance, new double[] {1e-30}, derivative);
    }
    force[0] = 1000;
    form(differences, balance, new double[] {1e-30}, derivative);
    // Round-off of the force, 1.1e-13, over the change, 7.6e-10.
    assertThat(derivative[0]).isCloseTo(1, within(2e-4));
  }

  @Test
  void pointMovedOutOfTheDomainIsMovedTheOtherWay() {
    FunctionOde root =
        new FunctionOde(1, (t, y, yDot) -> yDot[0] = 2 + Math.sqrt(1 - y[0]) * (1 - y[0]));
    double[] fy = evaluate(root, new double[] {1}, new double[] {1});
    assertThat(fy[0]).isCloseTo(0, within(1e-3));
  }

  @Test
  void componentNotFiniteOnBothSidesIsNamed() {
    FunctionOde needle =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = 0;
              yDot[1] = y[0] == 1 ? 0 : Double.NaN;
            });
    JacobianDifferences differences = differences(new DenseLayout(2), new double[] {1, 1});
    TrialOutcome attempt = form(differences, at0(needle), new double[] {1, 1}, new double[4]);
    assertThat(attempt).isEqualTo(TrialOutcome.NOT_FINITE);
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
    AtomicInteger evaluations = new AtomicInteger();
    DifferencedFunction equations = counted(at0(brusselator), evaluations);
    form(differences(dense, threshold), equations, y, full);
    form(differences(band, threshold), equations, y, narrow);
    for (int j = 0; j < 40; j++) {
      for (int i = band.firstRow(j); i <= band.lastRow(j); i++) {
        assertThat(narrow[band.index(i, j)]).isEqualTo(full[dense.index(i, j)]);
      }
    }
    assertThat(evaluations.get()).isEqualTo(1 + 40 + 1 + 5);
  }
}
