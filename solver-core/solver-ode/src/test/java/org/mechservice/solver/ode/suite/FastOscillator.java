package org.mechservice.solver.ode.suite;

/**
 * An undamped oscillator of 1000 rad/s over 159 periods, with a slow motion on top. Exact: sin t +
 * cos 1000 t and its derivative.
 */
public final class FastOscillator implements ExactProblem {
  private static final double FREQUENCY = 1000;

  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          1.0,
          new double[] {1.0, 1.0},
          new double[] {1.0, 1000.0},
          new double[] {1.4038500610985996, -826.3392382261344},
          0.5,
          new double[] {-0.40442373482727495, 468.6493878843665});

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    double s = StrictMath.sin(t);
    yDot[0] = y[1];
    yDot[1] = -FREQUENCY * FREQUENCY * y[0] + FREQUENCY * FREQUENCY * s - s;
  }

  @Override
  public double[] exact(double t) {
    return new double[] {
      StrictMath.sin(t) + StrictMath.cos(FREQUENCY * t),
      StrictMath.cos(t) - FREQUENCY * StrictMath.sin(FREQUENCY * t)
    };
  }
}
