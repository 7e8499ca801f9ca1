package org.mechservice.solver.integration;

/**
 * Bounds of DE: a step passes the end when its size says so and the solution is interpolated there,
 * but never goes beyond ten times the interval. Shampine and Gordon 1975.
 */
final class StepsPastEnd implements StepBounds {
  private static final double INTERVALS_ALLOWED = 10;

  /** Smallest step in units of u |t|, where u = 2⁻⁵². */
  private static final double SMALLEST_ROUNDOFFS = 4;

  private double tEnd;
  private double tLast;
  private double direction;
  private double largest;

  @Override
  public void begin(double t0, double tEnd, double maxStep) {
    this.tEnd = tEnd;
    direction = Math.signum(tEnd - t0);
    tLast = t0 + INTERVALS_ALLOWED * (tEnd - t0);
    largest = maxStep;
  }

  @Override
  public double smallest(double t) {
    return Math.max(SMALLEST_ROUNDOFFS * Math.ulp(1.0) * Math.abs(t), Double.MIN_NORMAL);
  }

  @Override
  public double bounded(double t, double h) {
    double size = Math.min(Math.min(largest, Math.abs(h)), Math.abs(tLast - t));
    return Math.copySign(Math.max(size, smallest(t)), h);
  }

  @Override
  public double endOf(double t, double h) {
    return t + h;
  }

  @Override
  public boolean reachedAt(double t) {
    return (t - tEnd) * direction >= 0;
  }
}
