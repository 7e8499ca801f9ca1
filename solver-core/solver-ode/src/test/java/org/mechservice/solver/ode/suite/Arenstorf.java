package org.mechservice.solver.ode.suite;

/**
 * One period of Arenstorf's orbit in the restricted three-body problem, earth and moon; state [x,
 * y, x', y']. Arenstorf 1963; Hairer, Nørsett and Wanner I, II.0. Very sensitive near the moon: the
 * end value, confirmed to 19 digits, is only almost the start.
 */
public final class Arenstorf implements SuiteProblem {
  private static final double MOON_MASS = 0.012277471;
  private static final double EARTH_MASS = 1 - MOON_MASS;

  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          17.065216560157964,
          new double[] {0.994, 0.0, 0.0, -2.0015851063790824},
          new double[] {1.0, 1.0, 1.0, 1.0},
          new double[] {0.994, 1.738625132357557e-27, 2.8474652816221947e-25, -2.0015851063790824},
          8.0,
          new double[] {
            -1.1745535072769004, -0.27594507701453846, -0.2531707499679332, 0.44737674785987463
          });

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    double earth = MOON_MASS * (y[0] - EARTH_MASS) / cubedDistance(y[0] - EARTH_MASS, y[1]);
    double moon = EARTH_MASS * (y[0] + MOON_MASS) / cubedDistance(y[0] + MOON_MASS, y[1]);
    double pull =
        EARTH_MASS / cubedDistance(y[0] + MOON_MASS, y[1])
            + MOON_MASS / cubedDistance(y[0] - EARTH_MASS, y[1]);
    yDot[0] = y[2];
    yDot[1] = y[3];
    yDot[2] = y[0] + 2 * y[3] - moon - earth;
    yDot[3] = y[1] - 2 * y[2] - pull * y[1];
  }

  private static double cubedDistance(double x, double y) {
    double squared = x * x + y * y;
    return squared * Math.sqrt(squared);
  }
}
