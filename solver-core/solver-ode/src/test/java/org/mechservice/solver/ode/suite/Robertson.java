package org.mechservice.solver.ode.suite;

/**
 * Robertson's chemical kinetics over eleven decades of time, 1966; IVP Test Set, ROBER.
 *
 * <p>End value confirmed to 22 digits by collocation of order 13 and 17 in quadruple precision, and
 * by the published one to 13.7.
 */
public final class Robertson implements SuiteProblem {
  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          100000000000.0,
          new double[] {1.0, 0.0, 0.0},
          new double[] {1e-06, 1e-06, 1e-06},
          new double[] {2.083340149701294e-08, 8.333360770334784e-14, 0.9999999791665152},
          400000.0,
          new double[] {0.004938274520979815, 1.9849940879543756e-08, 0.9950617056290793});

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    double slow = 0.04 * y[0];
    double back = 1e4 * y[1] * y[2];
    double fast = 3e7 * y[1] * y[1];
    yDot[0] = -slow + back;
    yDot[1] = slow - back - fast;
    yDot[2] = fast;
  }
}
