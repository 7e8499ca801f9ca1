package org.mechservice.solver.ode.suite;

/**
 * Transistor amplifier, 8 nodal voltages with a singular capacity matrix of rank 5: of index 1, yet
 * no component is algebraic by itself. Rentrop, Roche and Steinebach 1989; IVP Test Set, TRANSAMP.
 *
 * <p>End value confirmed to 23 digits by collocation of order 13 and 17 in quadruple precision, and
 * by the published one to 13.1.
 */
public final class TransistorAmplifier implements ResidualProblem {
  private static final double SUPPLY = 6;
  private static final double THERMAL = 0.026;
  private static final double GAIN = 0.99;
  private static final double SATURATION = 1e-6;
  private static final double R0 = 1000;
  private static final double R = 9000;

  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          0.2,
          new double[] {0, 3, 3, 6, 3, 3, 6, 0},
          new double[] {1, 1, 1, 1, 1, 1, 1, 1},
          new double[] {
            -0.005562145012262275,
            3.006522471903043,
            2.8499587886081286,
            2.9264225362062417,
            2.7046178650105546,
            2.761837778393144,
            4.770927631616773,
            1.2369958680915476
          },
          0.05,
          new double[] {
            -0.005561938096498564,
            3.0065215300573267,
            2.8499578317321466,
            3.467288462743719,
            2.4341844774837162,
            2.494964052372953,
            5.535355377834852,
            0.47269434591119996
          });

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public double[] initialDerivative() {
    return new double[] {
      51.338775,
      51.338775,
      -166.66666666666666,
      -24.9757667,
      -24.9757667,
      -83.33333333333333,
      -10.00564453,
      -10.00564453
    };
  }

  @Override
  public void residual(double t, double[] y, double[] yDot, double[] residual) {
    double input = 0.1 * StrictMath.sin(200 * Math.PI * t);
    double first = current(y[1] - y[2]);
    double second = current(y[4] - y[5]);
    double c1 = 1e-6 * (yDot[1] - yDot[0]);
    double c3 = 3e-6 * (yDot[4] - yDot[3]);
    double c5 = 5e-6 * (yDot[7] - yDot[6]);
    residual[0] = c1 - (y[0] - input) / R0;
    residual[1] = -c1 + SUPPLY / R - 2 * y[1] / R + (GAIN - 1) * first;
    residual[2] = -2e-6 * yDot[2] + first - y[2] / R;
    residual[3] = c3 + SUPPLY / R - y[3] / R - GAIN * first;
    residual[4] = -c3 + SUPPLY / R - 2 * y[4] / R + (GAIN - 1) * second;
    residual[5] = -4e-6 * yDot[5] + second - y[5] / R;
    residual[6] = c5 + SUPPLY / R - y[6] / R - GAIN * second;
    residual[7] = -c5 - y[7] / R;
  }

  private static double current(double voltage) {
    return SATURATION * (StrictMath.exp(voltage / THERMAL) - 1);
  }
}
