package org.mechservice.solver.ode.suite;

/**
 * Van der Pol's oscillator with μ = 1, DETEST E2, Hull et al. 1972. End value confirmed to 21
 * digits by collocation of order 13 and 17 in quadruple precision.
 */
public final class VanDerPol implements SuiteProblem {

  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          20.0,
          new double[] {2.0, 0.0},
          new double[] {1.0, 1.0},
          new double[] {2.0081497621749484, -0.04250887527320215},
          8.0,
          new double[] {1.213232442638908, -0.9878139211589111});

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    yDot[0] = y[1];
    yDot[1] = (1 - y[0] * y[0]) * y[1] - y[0];
  }
}
