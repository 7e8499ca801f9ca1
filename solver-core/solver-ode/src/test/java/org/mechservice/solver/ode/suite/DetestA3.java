package org.mechservice.solver.ode.suite;

/** y' = y cos t, DETEST A3, Hull et al. 1972. Exact: exp(sin t). */
public final class DetestA3 implements ExactProblem {

  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          20.0,
          new double[] {1.0},
          new double[] {1.0},
          new double[] {2.4916502718504145},
          8.0,
          new double[] {2.689507917609784});

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    yDot[0] = y[0] * StrictMath.cos(t);
  }

  @Override
  public double[] exact(double t) {
    return new double[] {StrictMath.exp(StrictMath.sin(t))};
  }
}
