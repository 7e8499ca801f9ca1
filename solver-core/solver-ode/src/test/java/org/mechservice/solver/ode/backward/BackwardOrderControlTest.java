package org.mechservice.solver.ode.backward;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.MaximumNorm;
import org.mechservice.solver.ode.suite.FunctionOde;

class BackwardOrderControlTest {
  private static final BackwardFormulas NDF = BackwardFormulas.NDF;

  private final MaximumNorm norm = new MaximumNorm();
  private final BackwardDifferences differences = new BackwardDifferences(1);
  private final BackwardOrderControl control = new BackwardOrderControl(NDF, false);

  /** Errors allowed are 1. */
  BackwardOrderControlTest() {
    OdeSystem system = new FunctionOde(1, (t, y, yDot) -> yDot[0] = 0);
    norm.begin(0, new double[] {1}, new Manifold(system));
    norm.weigh(new double[1]);
  }

  /**
   * Fails a step by far at its order.
   *
   * @param errorBelow that of the order below
   */
  private void fail(int order, double errorBelow) {
    differences.correction[0] = 1e6;
    differences.tried(order)[0] = errorBelow / NDF.errorConstant(order - 1) - 1e6;
    control.estimate(norm.of(differences.correction));
    control.beginStep();
  }

  /** Raises the order by accepted steps that would be far more accurate at the next one. */
  private void raiseTo(int order) {
    control.begin(BackwardFormulas.HIGHEST_ORDER, false);
    differences.correction[0] = 1;
    for (int i = 0; i < 10 && control.order() < order; i++) {
      int k = control.order();
      control.estimate(norm.of(differences.correction));
      differences.accepted(k)[0] = 1e3;
      differences.accepted(k + 2)[0] = 1e-9;
      control.accept(differences, norm);
    }
    assertThat(control.order()).isEqualTo(order);
  }

  @ParameterizedTest
  @CsvSource({"4, 84, 0.2", "4, 88, 0.2", "5, 75, 0.2", "5, 84, 0.2", "4, 84, 0", "5, 84, 0"})
  void afterFailureTheOrderBelowIsTriedWithStepsAtWhichTheFastestOscillationDecays(
      int order, double degrees, double errorBelow) {
    raiseTo(order);
    int below = order - 1;
    double damping = UnstableStepsTest.damping(degrees);
    double advance = 1.2 * NDF.unstable().first(below, damping);
    assertThat(UnstableStepsTest.growth(NDF, below, advance, degrees)).isGreaterThan(1);

    control.follow(advance, damping);
    fail(order, errorBelow);
    double factor = control.reject(differences, norm);

    assertThat(control.order()).isEqualTo(below);
    assertThat(UnstableStepsTest.growth(NDF, below, factor * advance, degrees)).isLessThan(1);
    // It is not shorter than that asks for.
    assertThat(factor).isGreaterThan(0.7);
  }

  @ParameterizedTest
  @CsvSource({"4, 84", "5, 84"})
  void afterFailureTheOrderBelowKeepsTheStepWhereNothingOscillates(int order, double degrees) {
    raiseTo(order);
    control.follow(1.2 * NDF.unstable().first(order - 1, UnstableStepsTest.damping(degrees)), 0);
    fail(order, 0.2);

    assertThat(control.reject(differences, norm)).isEqualTo(1);
    assertThat(control.order()).isEqualTo(order - 1);
  }
}
