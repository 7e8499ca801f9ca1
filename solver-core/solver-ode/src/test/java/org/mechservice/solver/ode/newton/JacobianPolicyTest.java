package org.mechservice.solver.ode.newton;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.backward.BackwardDifferences;
import org.mechservice.solver.ode.backward.BackwardFormulas;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.MaximumNorm;
import org.mechservice.solver.ode.suite.ImplicitOde;

/** A mass that moves with its place, and none beyond 1: what a prediction goes too far into. */
class JacobianPolicyTest {
  private final ResidualEquations equations;
  private final BackwardDifferences differences = new BackwardDifferences(1);

  JacobianPolicyTest() {
    ImplicitOde mass =
        new ImplicitOde(1, (t, y, yDot, r) -> r[0] = y[0] > 1 ? 1 : y[0] * (yDot[0] - 1)) {
          @Override
          public boolean massMatrixMoves() {
            return true;
          }
        };
    Manifold manifold = new Manifold(mass);
    Residual residual = new Residual(mass, manifold, () -> false);
    ResidualLinearisation linearisation =
        new ResidualJacobians(mass, residual, new double[] {1e-6});
    equations =
        new ResidualEquations(
            residual,
            linearisation,
            new double[] {1},
            2,
            new MaximumNorm(),
            new IntegratorSettings(1e-6, 1e-6));
  }

  /** Forms ahead if that is wanted, at y = t; returns whether the matrix is regular. */
  private boolean regularAt(double t) {
    differences.begin(new double[] {t});
    differences.predict(1, BackwardFormulas.BDF);
    if (equations.derivatives().wantedAhead(t)) {
      assertThat(equations.derivatives().formAhead(t, 0.1, differences))
          .isEqualTo(TrialOutcome.PASSED);
    }
    return equations.factors().factorAnew(0.1);
  }

  /** The matrix being singular, no step was begun by which its age could be told. */
  @Test
  void matrixSingularAtTheEndOfALongStepIsFormedAnewForAShorterOne() {
    assertThat(regularAt(1.5)).isFalse();
    assertThat(equations.derivatives().renew()).isFalse();
    assertThat(regularAt(0.5)).isFalse();
    assertThat(equations.derivatives().renew()).isTrue();
    assertThat(regularAt(0.5)).isTrue();
  }
}
