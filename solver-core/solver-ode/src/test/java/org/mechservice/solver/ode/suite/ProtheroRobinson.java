package org.mechservice.solver.ode.suite;

/** y' = λ (y − cos t) − sin t with λ = −10⁶, Prothero and Robinson 1974. Exact: cos t. */
public final class ProtheroRobinson implements ExactProblem {
  private static final double LAMBDA = -1e6;

  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          10.0,
          new double[] {1.0},
          new double[] {1.0},
          new double[] {-0.8390715290764524},
          4.0,
          new double[] {-0.6536436208636119});

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    yDot[0] = LAMBDA * (y[0] - StrictMath.cos(t)) - StrictMath.sin(t);
  }

  @Override
  public double[] exact(double t) {
    return new double[] {StrictMath.cos(t)};
  }
}
