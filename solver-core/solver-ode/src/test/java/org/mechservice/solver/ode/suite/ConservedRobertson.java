package org.mechservice.solver.ode.suite;

/**
 * Robertson's kinetics with the conservation of mass in place of the third rate, a
 * differential-algebraic system of index 1; MATLAB hb1dae, SUNDIALS idaRoberts.
 *
 * <p>End value confirmed to 23 digits by collocation of order 13 and 17 in quadruple precision.
 */
public final class ConservedRobertson implements ResidualProblem {
  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          4e10,
          new double[] {1, 0, 0},
          new double[] {1e-06, 1e-06, 1e-06},
          new double[] {5.208345176799239e-08, 2.083338177925489e-13, 0.99999994791634},
          4e5,
          new double[] {0.004938274520979815, 1.9849940879543756e-08, 0.9950617056290793});

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public double[] initialDerivative() {
    return new double[] {-0.04, 0.04, 0};
  }

  @Override
  public Component component(int index) {
    return index == 2 ? Component.ALGEBRAIC : Component.DIFFERENTIAL;
  }

  @Override
  public void residual(double t, double[] y, double[] yDot, double[] residual) {
    residual[0] = yDot[0] - (-0.04 * y[0] + 1e4 * y[1] * y[2]);
    residual[1] = yDot[1] - (0.04 * y[0] - 1e4 * y[1] * y[2] - 3e7 * y[1] * y[1]);
    residual[2] = -(y[0] + y[1] + y[2] - 1);
  }
}
