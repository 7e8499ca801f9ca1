package org.mechservice.solver.ode.suite;

/**
 * An oscillation with eigenvalues −10 ± 100i that dies out soon and four real modes. After DETEST
 * stiff B5, Enright, Hull and Lindberg 1975.
 */
public final class DampedOscillator implements ExactProblem {
  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          20.0,
          new double[] {1.0, 1.0, 1.0, 1.0, 1.0, 1.0},
          new double[] {1.0, 1.0, 1.0, 1.0, 1.0, 1.0},
          new double[] {
            7.785524461725605e-88,
            -1.7956044336063368e-87,
            1.8048513878454153e-35,
            2.061153622438558e-09,
            4.5399929762484854e-05,
            0.1353352832366127
          },
          1.0,
          new double[] {
            1.6160251694207334e-05,
            6.213818077524466e-05,
            0.01831563888873418,
            0.36787944117144233,
            0.6065306597126334,
            0.9048374180359596
          });

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    yDot[0] = -10 * y[0] + 100 * y[1];
    yDot[1] = -100 * y[0] - 10 * y[1];
    yDot[2] = -4 * y[2];
    yDot[3] = -y[3];
    yDot[4] = -0.5 * y[4];
    yDot[5] = -0.1 * y[5];
  }

  @Override
  public double[] exact(double t) {
    double decay = StrictMath.exp(-10 * t);
    double c = StrictMath.cos(100 * t);
    double s = StrictMath.sin(100 * t);
    return new double[] {
      decay * (c + s),
      decay * (c - s),
      StrictMath.exp(-4 * t),
      StrictMath.exp(-t),
      StrictMath.exp(-0.5 * t),
      StrictMath.exp(-0.1 * t)
    };
  }
}
