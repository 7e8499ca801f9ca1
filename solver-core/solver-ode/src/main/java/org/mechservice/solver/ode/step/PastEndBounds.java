package org.mechservice.solver.ode.step;

/**
 * Bounds of DE: a step passes the end when its size says so and the solution is interpolated there,
 * but never goes beyond ten times the interval, nor past a place where it is told to stop; to that
 * it is stretched by up to a tenth. Shampine and Gordon 1975.
 */
public final class PastEndBounds implements StepBounds {
  private static final double INTERVALS_ALLOWED = 10;

  /** Smallest step in units of u |t|, where u = 2⁻⁵². */
  private static final double SMALLEST_ROUNDOFFS = 4;

  /** A step is stretched by at most this factor to reach the place where it is to stop. */
  private static final double STRETCH = 1.1;

  private double tEnd;
  private double stop;
  private double tLast;
  private double direction;
  private double largest;

  @Override
  public void begin(double t0, double tEnd, double maxStep) {
    this.tEnd = tEnd;
    direction = Math.signum(tEnd - t0);
    stop = direction * Double.POSITIVE_INFINITY;
    tLast = t0 + INTERVALS_ALLOWED * (tEnd - t0);
    largest = maxStep;
  }

  @Override
  public void stopAt(double place) {
    stop = place;
  }

  @Override
  public double smallest(double t) {
    return Math.max(SMALLEST_ROUNDOFFS * Math.ulp(1.0) * Math.abs(t), Double.MIN_NORMAL);
  }

  @Override
  public double bounded(double t, double h) {
    double size = Math.min(Math.min(largest, Math.abs(h)), Math.abs(tLast - t));
    size = Math.max(size, smallest(t));
    double remaining = stop - t;
    return STRETCH * size >= Math.abs(remaining) ? remaining : Math.copySign(size, h);
  }

  @Override
  public double endOf(double t, double h) {
    return h == stop - t ? stop : t + h;
  }

  @Override
  public double inProblem(double t) {
    return reachedAt(t) ? tEnd : t;
  }

  @Override
  public boolean reachedAt(double t) {
    return (t - tEnd) * direction >= 0;
  }
}
