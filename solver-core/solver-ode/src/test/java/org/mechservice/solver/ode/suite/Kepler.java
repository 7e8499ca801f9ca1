package org.mechservice.solver.ode.suite;

/**
 * Two bodies, one fixed, eccentricity 0.9; state [x, y, x', y']. DETEST D5, Hull et al. 1972. The
 * exact solution follows from Kepler's equation u − 0.9 sin u = t.
 */
public final class Kepler implements ExactProblem {
  private static final double ECCENTRICITY = 0.9;

  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          20.0,
          new double[] {0.1, 0.0, 0.0, 4.358898943540674},
          new double[] {1.0, 1.0, 1.0, 1.0},
          new double[] {
            -1.2952662509875743, 0.4003938963792322, -0.6775390924707566, -0.12708381542786862
          },
          10.0,
          new double[] {
            -1.8538537094055791, -0.13088540483992556, 0.16156945255843133, -0.2237192767918971
          });

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    double squared = y[0] * y[0] + y[1] * y[1];
    double cubed = squared * Math.sqrt(squared);
    yDot[0] = y[2];
    yDot[1] = y[3];
    yDot[2] = -y[0] / cubed;
    yDot[3] = -y[1] / cubed;
  }

  @Override
  public double[] exact(double t) {
    double u = eccentricAnomaly(t);
    double c = StrictMath.cos(u);
    double s = StrictMath.sin(u);
    double minor = Math.sqrt(1 - ECCENTRICITY * ECCENTRICITY);
    double speed = 1 / (1 - ECCENTRICITY * c);
    return new double[] {c - ECCENTRICITY, minor * s, -s * speed, minor * c * speed};
  }

  /** Solves u − e sin u = t by Newton's method; u = t + e is beyond every root's flat side. */
  private static double eccentricAnomaly(double t) {
    double turns = 2 * Math.PI * Math.rint(t / (2 * Math.PI));
    double mean = t - turns;
    double u = mean + Math.copySign(ECCENTRICITY, mean);
    for (int i = 0; i < 30; i++) {
      u -= (u - ECCENTRICITY * StrictMath.sin(u) - mean) / (1 - ECCENTRICITY * StrictMath.cos(u));
    }
    return u + turns;
  }
}
