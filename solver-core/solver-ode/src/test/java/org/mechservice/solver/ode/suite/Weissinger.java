package org.mechservice.solver.ode.suite;

/** Weissinger's equation, implicit and cubic in y', with the solution √(t² + ½); MATLAB ode15i. */
public final class Weissinger implements ResidualProblem {
  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          10,
          new double[] {1.224744871391589},
          new double[] {1},
          new double[] {10.024968827881711},
          5,
          new double[] {5.049752469181039});

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public double[] initialDerivative() {
    return new double[] {0.816496580927726};
  }

  @Override
  public double start() {
    return 1;
  }

  @Override
  public void residual(double t, double[] y, double[] yDot, double[] residual) {
    double y2 = y[0] * y[0];
    double slope = yDot[0];
    residual[0] =
        t * y2 * slope * slope * slope
            - y2 * y[0] * slope * slope
            + t * (t * t + 1) * slope
            - t * t * y[0];
  }
}
