package org.mechservice.solver.ode.suite;

/**
 * A rigid body turning freely, DETEST B5, Hull et al. 1972. Exact: y_0 = sn(t, m), y_1 = cn(t, m),
 * y_2 = dn(t, m), m = 0.51.
 */
public final class EulerRigidBody implements SuiteProblem {

  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          20.0,
          new double[] {0.0, 1.0, 1.0},
          new double[] {1.0, 1.0, 1.0},
          new double[] {-0.9396570798729204, -0.34211777540007493, 0.7414126596199953},
          8.0,
          new double[] {0.5109096692261356, 0.859634404785686, 0.9310614201246514});

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    yDot[0] = y[1] * y[2];
    yDot[1] = -y[0] * y[2];
    yDot[2] = -0.51 * y[0] * y[1];
  }
}
