package org.mechservice.solver.ode.suite;

/**
 * A flame that smoulders for 10⁴ units of time, flares up and burns steadily; y' = y² − y³, Moler
 * 2003. The end value is 1 to all digits; the checkpoint lies in the flare-up.
 */
public final class Flame implements SuiteProblem {
  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          20000.0,
          new double[] {0.0001},
          new double[] {1.0},
          new double[] {1.0},
          10000.0,
          new double[] {0.13586618357002986});

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    yDot[0] = y[0] * y[0] - y[0] * y[0] * y[0];
  }
}
