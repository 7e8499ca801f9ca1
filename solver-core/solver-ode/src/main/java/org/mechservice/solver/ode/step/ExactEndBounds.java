package org.mechservice.solver.ode.step;

/**
 * Bounds of the MATLAB ODE Suite: at most a tenth of the interval unless the user says otherwise,
 * at least 16 units of round-off of t, and the last step ends exactly at the end, to which it is
 * stretched by up to a tenth. Shampine and Reichelt 1997.
 */
public final class ExactEndBounds implements StepBounds {
  /** A step is stretched by at most this factor to reach the end. */
  private static final double STRETCH = 1.1;

  private static final double LARGEST_SHARE_OF_INTERVAL = 0.1;

  /** Smallest step in units of u |t|, where u = 2⁻⁵². */
  private static final double SMALLEST_ROUNDOFFS = 16;

  private double tEnd;
  private double stop;
  private double direction;
  private double largest;

  @Override
  public void begin(double t0, double tEnd, double maxStep) {
    this.tEnd = tEnd;
    stop = tEnd;
    direction = Math.signum(tEnd - t0);
    double interval = Math.abs(tEnd - t0);
    largest =
        Double.isInfinite(maxStep)
            ? LARGEST_SHARE_OF_INTERVAL * interval
            : Math.min(interval, maxStep);
  }

  @Override
  public void stopAt(double place) {
    stop = direction * (place - tEnd) < 0 ? place : tEnd;
  }

  @Override
  public double smallest(double t) {
    return SMALLEST_ROUNDOFFS * Math.max(Math.ulp(1.0) * Math.abs(t), Double.MIN_NORMAL);
  }

  @Override
  public double bounded(double t, double h) {
    double size = Math.min(largest, Math.abs(h));
    size = Math.max(size, smallest(t));
    double remaining = stop - t;
    return STRETCH * size >= Math.abs(remaining) ? remaining : Math.copySign(size, h);
  }

  @Override
  public double endOf(double t, double h) {
    return h == stop - t ? stop : t + h;
  }

  @Override
  public boolean reachedAt(double t) {
    return t == tEnd;
  }
}
