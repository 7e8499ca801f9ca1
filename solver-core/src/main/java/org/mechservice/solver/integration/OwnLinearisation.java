package org.mechservice.solver.integration;

/** The linear algebra of a system that brings its own. */
final class OwnLinearisation implements ResidualLinearisation {
  private final LinearisedSystem system;
  private final Residual residual;
  private final Manifold manifold;

  OwnLinearisation(LinearisedSystem system, Residual residual) {
    this.system = system;
    this.residual = residual;
    manifold = residual.manifold();
  }

  @Override
  public Attempt form(double t, double[] y, double[] yDot) {
    if (residual.stopped()) {
      return Attempt.STOPPED;
    }
    return system.linearise(residual.breakpoints().inside(t), y, yDot)
        ? Attempt.PASSED
        : Attempt.NOT_FINITE;
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
  public boolean algebraic(int component) {
    return manifold.algebraic(component);
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
}
