package org.mechservice.solver.ode.suite;

/**
 * High irradiance responses of photomorphogenesis, eight reactants, Schäfer 1975; IVP Test Set,
 * HIRES. End value confirmed to 17.6 digits by collocation of order 13 and 17 in quadruple
 * precision, and by the published one to 15.6.
 */
public final class Hires implements SuiteProblem {
  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          321.8122,
          new double[] {1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0057},
          new double[] {0.001, 0.001, 0.001, 0.001, 0.001, 0.001, 0.001, 0.001},
          new double[] {
            0.0007371312573325667,
            0.00014424857263161848,
            5.888729740967575e-05,
            0.001175651343283149,
            0.0023863561988313304,
            0.0062389682527427956,
            0.0028499983951857685,
            0.0028500016048142313
          },
          5.0,
          new double[] {
            0.031651675704569275,
            0.006481549531058165,
            0.004583451064747285,
            0.08974323273518033,
            0.16245145375265563,
            0.6850438961444316,
            0.005646700341920548,
            5.329965807945244e-05
          });

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    double binding = 280 * y[5] * y[7];
    yDot[0] = -1.71 * y[0] + 0.43 * y[1] + 8.32 * y[2] + 0.0007;
    yDot[1] = 1.71 * y[0] - 8.75 * y[1];
    yDot[2] = -10.03 * y[2] + 0.43 * y[3] + 0.035 * y[4];
    yDot[3] = 8.32 * y[1] + 1.71 * y[2] - 1.12 * y[3];
    yDot[4] = -1.745 * y[4] + 0.43 * y[5] + 0.43 * y[6];
    yDot[5] = -binding + 0.69 * y[3] + 1.71 * y[4] - 0.43 * y[5] + 0.69 * y[6];
    yDot[6] = binding - 1.81 * y[6];
    yDot[7] = -binding + 1.81 * y[6];
  }
}
