package org.mechservice.solver.ode.newton;

import org.mechservice.solver.ode.LinearisedSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.step.Manifold;

/** The linear algebra of a system that brings its own. */
public final class UserLinearisation implements ResidualLinearisation {
  private final LinearisedSystem system;
  private final Residual residual;
  private final Manifold manifold;

  /** Where the derivatives kept are those of, length n. */
  private final double[] formedState;

  private final double[] formedSlope;
  private double formedTime;
  private boolean formed;

  public UserLinearisation(LinearisedSystem system, Residual residual) {
    this.system = system;
    this.residual = residual;
    manifold = residual.manifold();
    formedState = new double[manifold.dimension()];
    formedSlope = new double[manifold.dimension()];
  }

  @Override
  public TrialOutcome form(double t, double[] y, double[] yDot) {
    if (residual.stopped()) {
      return TrialOutcome.STOPPED;
    }
    formedTime = residual.breakpoints().inside(t);
    System.arraycopy(y, 0, formedState, 0, y.length);
    System.arraycopy(yDot, 0, formedSlope, 0, yDot.length);
    formed = true;
    return system.linearise(formedTime, y, yDot) ? TrialOutcome.PASSED : TrialOutcome.NOT_FINITE;
  }

  /** The system's derivatives are its own affair. */
  @Override
  public void testColumns(ColumnTest.Maker tests) {}

  @Override
  public boolean formsMatrix() {
    return false;
  }

  @Override
  public TrialOutcome formMatrix(double t, double[] y, double[] yDot, double hGamma) {
    return form(t, y, yDot);
  }

  @Override
  public void knowRate(double rate) {}

  @Override
  public void abandon() {}

  /** The matrix for hγ = 0 is singular if there are algebraic components. */
  @Override
  public boolean factor(double hGamma) {
    return (hGamma != 0 || !manifold.anyAlgebraic()) && system.factor(hGamma);
  }

  @Override
  public void solve(double hGamma, double[] r) {
    if (hGamma != 0) {
      for (int l = 0; l < r.length; l++) {
        r[l] *= hGamma;
      }
    }
    system.solve(r);
    if (manifold.completes()) {
      manifold.clearPassive(r);
    }
  }

  @Override
  public boolean solveUnstiff(double[] r) {
    boolean solved = !manifold.anyAlgebraic() && system.solveForDerivative(r);
    if (solved && manifold.completes()) {
      manifold.clearPassive(r);
    }
    return solved;
  }

  @Override
  public boolean doubtsDeclarations() {
    return false;
  }

  @Override
  public boolean algebraic(int component) {
    return manifold.algebraic(component);
  }

  @Override
  public boolean allDifferential() {
    return !manifold.anyAlgebraic();
  }

  @Override
  public int singularComponent() {
    return system.singularComponent();
  }

  @Override
  public double reciprocalCondition() {
    return system.reciprocalCondition();
  }

  @Override
  public int notFiniteComponent() {
    return -1;
  }

  @Override
  public double magnitude(int row) {
    return 0;
  }

  /** The derivatives are formed anew where they were. */
  @Override
  public void transfer(SavedState state) {
    formedTime = state.number(formedTime);
    state.numbers(formedState);
    state.numbers(formedSlope);
    formed = state.flag(formed);
    if (state.restoring() && formed) {
      system.linearise(formedTime, formedState, formedSlope);
    }
  }
}
