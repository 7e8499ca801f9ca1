package org.mechservice.solver.ode.newton;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.MaximumNorm;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.suite.ImplicitOde;

/** Two equations y' + 1e6 y = 0, of which a step of hγ = 1 leaves something. */
class NegligibleResidualTest {
  private static final double STIFFNESS = 1e6;

  private final Counted linearisation = new Counted();
  private final MaximumNorm norm = new MaximumNorm();
  private final NegligibleResidual slight;

  NegligibleResidualTest() {
    Manifold manifold = new Manifold(new ImplicitOde(2, (t, y, yDot, residual) -> {}));
    slight = new NegligibleResidual(linearisation, manifold);
    norm.begin(0.1, new double[] {0.1, 0.1}, manifold);
    norm.weigh(new double[] {1, 1});
  }

  private boolean isSlight(double first, double second, double hGamma) {
    return slight.is(new double[] {first, second}, hGamma, norm, 1);
  }

  @Test
  void stiffnessMakesNothingSlight() {
    // As it is, a change by a 1e7th would solve it.
    assertThat(isSlight(0.11, 0, 1)).isFalse();
    assertThat(isSlight(0.09, 0, 1)).isTrue();
  }

  @Test
  void factorsAreThoseOfTheStepAfterwards() {
    assertThat(isSlight(0.09, 0, 1)).isTrue();
    assertThat(linearisation.factored).isEqualTo(1);
  }

  @Test
  void oneAnswerHoldsForLessOfTheSame() {
    assertThat(isSlight(0.01, -0.01, 1)).isTrue();
    int factorisations = linearisation.factorisations;
    assertThat(isSlight(-0.04, 0.03, 1)).isTrue();
    assertThat(linearisation.factorisations).isEqualTo(factorisations);
  }

  /** With other signs, what had cancelled adds up. */
  @Test
  void moreThanHalfOfWhatIsKnownToBeSlightIsLookedAtAnew() {
    assertThat(isSlight(0.01, -0.01, 1)).isTrue();
    int factorisations = linearisation.factorisations;
    assertThat(isSlight(0.06, 0.06, 1)).isTrue();
    assertThat(linearisation.factorisations).isGreaterThan(factorisations);
  }

  @Test
  void otherRowsAreLookedAtAnew() {
    assertThat(isSlight(0.01, 0, 1)).isTrue();
    assertThat(isSlight(0, 0.11, 1)).isFalse();
  }

  @Test
  void nothingIsKnownOfLongerSteps() {
    assertThat(isSlight(0.01, 0.01, 1)).isTrue();
    assertThat(isSlight(0.04, 0.04, 3)).isFalse();
  }

  @Test
  void nothingIsKnownOfSmallerTolerances() {
    assertThat(isSlight(0.01, 0.01, 1)).isTrue();
    norm.begin(
        0.01, new double[] {0.01, 0.01}, new Manifold(new FunctionOde(2, (t, y, yDot) -> {})));
    norm.weigh(new double[] {1, 1});
    assertThat(isSlight(0.04, 0.04, 1)).isFalse();
  }

  @Test
  void nothingIsKnownAfterNewDerivatives() {
    assertThat(isSlight(0.01, 0.01, 1)).isTrue();
    int factorisations = linearisation.factorisations;
    slight.forget();
    assertThat(isSlight(0.01, 0.01, 1)).isTrue();
    assertThat(linearisation.factorisations).isGreaterThan(factorisations);
  }

  @Test
  void keptFactorsOfTheDerivativeTellTheSameAndLeaveThoseOfTheStep() {
    linearisation.keepsDerivative = true;
    assertThat(isSlight(0.11, 0, 1)).isFalse();
    assertThat(isSlight(0.09, 0, 1)).isTrue();
    assertThat(linearisation.factorisations).isZero();
  }

  /** ∂F/∂y = 1e6 I, ∂F/∂y' = I; the rest is of no use here. */
  private static final class Counted implements ResidualLinearisation {
    private int factorisations;
    private double factored;
    private boolean keepsDerivative;

    @Override
    public boolean factor(double hGamma) {
      factorisations++;
      factored = hGamma;
      return true;
    }

    @Override
    public void solve(double hGamma, double[] residual) {
      for (int l = 0; l < residual.length; l++) {
        residual[l] *= hGamma / (1 + hGamma * STIFFNESS);
      }
    }

    @Override
    public TrialOutcome form(double t, double[] y, double[] yDot) {
      throw new UnsupportedOperationException();
    }

    @Override
    public void testColumns(ColumnTest.Maker tests) {}

    @Override
    public boolean formsMatrix() {
      return false;
    }

    @Override
    public TrialOutcome formMatrix(double t, double[] y, double[] yDot, double hGamma) {
      throw new UnsupportedOperationException();
    }

    @Override
    public void knowRate(double rate) {}

    @Override
    public void abandon() {}

    @Override
    public boolean solveUnstiff(double[] residual) {
      return keepsDerivative;
    }

    @Override
    public boolean algebraic(int component) {
      return false;
    }

    @Override
    public boolean doubtsDeclarations() {
      return false;
    }

    @Override
    public boolean allDifferential() {
      return true;
    }

    @Override
    public int singularComponent() {
      return -1;
    }

    @Override
    public double reciprocalCondition() {
      return 1;
    }

    @Override
    public int notFiniteComponent() {
      return -1;
    }

    @Override
    public double magnitude(int row) {
      return 0;
    }

    @Override
    public void transfer(SavedState state) {}
  }
}
