package org.mechservice.solver.integration;

import java.util.Arrays;

/**
 * A block on a spring, let go at rest and slowed down by friction of one unit: y'' = −s(y') − y,
 * with s = sgn, which no method is told of, or a hyperbolic tangent nearly as steep.
 *
 * @param width of the hyperbolic tangent; 0: a jump
 */
record DryFriction(double width) implements JacobianSystem {
  @Override
  public int dimension() {
    return 2;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    yDot[0] = y[1];
    yDot[1] = -(width == 0 ? Math.signum(y[1]) : StrictMath.tanh(y[1] / width)) - y[0];
  }

  /** Of the jump there is none. */
  @Override
  public void jacobian(double t, double[] y, double[] jacobian) {
    double cosh = width == 0 ? 1 : StrictMath.cosh(y[1] / width);
    jacobian[1] = -1;
    jacobian[2] = 1;
    jacobian[3] = width == 0 ? 0 : -1 / (width * cosh * cosh);
  }

  /** The same without its Jacobian. */
  OdeSystem differenced() {
    return new Ode(2, this::derivative);
  }

  /** The same as y' − f(t, y) = 0. */
  ResidualSystem residual() {
    return new Implicit(2, this::residual);
  }

  private void residual(double t, double[] y, double[] yDot, double[] residual) {
    derivative(t, y, residual);
    residual[0] = yDot[0] - residual[0];
    residual[1] = yDot[1] - residual[1];
  }

  /** The same with the derivatives of the residual. */
  ResidualJacobianSystem residualWithJacobians() {
    return new Known(this);
  }

  private record Known(DryFriction friction) implements ResidualJacobianSystem {
    @Override
    public int dimension() {
      return 2;
    }

    @Override
    public void residual(double t, double[] y, double[] yDot, double[] residual) {
      friction.residual(t, y, yDot, residual);
    }

    @Override
    public void jacobians(double t, double[] y, double[] yDot, double[] fy, double[] fyDot) {
      friction.jacobian(t, y, fy);
      Arrays.setAll(fy, i -> -fy[i]);
      fyDot[0] = 1;
      fyDot[3] = 1;
    }
  }

  /**
   * The solution for a jump: half periods of π round ±1, until the block stops where the spring is
   * weaker than friction.
   *
   * @param start y(0) > 0
   */
  static double[] exact(double start, double t) {
    double y = start;
    double since = 0;
    while (Math.abs(y) > 1) {
      double centre = Math.copySign(1, y);
      double phase = t - since;
      if (phase <= Math.PI) {
        double amplitude = y - centre;
        return new double[] {
          centre + amplitude * StrictMath.cos(phase), -amplitude * StrictMath.sin(phase)
        };
      }
      since += Math.PI;
      y = 2 * centre - y;
    }
    return new double[] {y, 0};
  }
}
