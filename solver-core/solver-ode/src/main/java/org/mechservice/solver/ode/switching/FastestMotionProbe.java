package org.mechservice.solver.ode.switching;

import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.step.ErrorNorm;

/**
 * Estimates the fastest motion of a problem by two evaluations of f: products of ∂f/∂y with a
 * vector in which that motion already prevails, by differences.
 *
 * <p>At a start that is the change of f over the first step of an Adams method. On the slow
 * solution of a stiff problem its prediction is far off, and f there differs from f at the start
 * mostly along the fastest motion; one product tells the rate ρ of that, and a difference along the
 * solution y''. A first step of the backward formula, √(2 tol / ‖y''‖), that is several times 1/ρ
 * long could not be taken by an Adams method. A start off the slow solution has ‖y''‖ of about ρ²
 * times the distance, and both methods begin alike.
 *
 * <p>Later it is the discrepancy of a step at the edge of stability. An oscillation that is hardly
 * damped leaves an Adams method there for good: the method takes from it what damping there is and
 * keeps it alive at some hundred tolerances, so that it looks like one that has to be followed. Two
 * products tell its damping; J² x = p J x + q x has the real part p / 2.
 */
final class FastestMotionProbe {
  /** Part of f at the start by which f changes over a first step of which nothing is suspected. */
  private static final double SUSPICIOUS = 0.35;

  /** Way in the direction looked at, in units of the error allowed. */
  private static final double WAY = 0.01;

  /** Way along the solution, in units of 1/ρ. */
  private static final double SHORT = 0.1;

  /** h ρ of the first step below which it is stable. */
  private static final double STABLE = 0.35;

  /** Cosine between a way and the answer of f from which on the fastest motion grows. */
  private static final double GROWS = 0.5;

  /** h ρ of a first step of the backward formula that no Adams method could take. */
  private static final double STIFF = 4;

  /** Part of J² x that a pair of eigenvalues may leave over. */
  private static final double ALONE = 0.1;

  private final OdeSystem system;
  private final ErrorNorm norm;
  private final double[] moved;
  private final double[] answer;
  private final double[] once;
  private long evaluations;
  private double rate;

  /**
   * @param norm of the Adams method at work
   */
  FastestMotionProbe(OdeSystem system, ErrorNorm norm) {
    this.system = system;
    this.norm = norm;
    int n = system.dimension();
    moved = new double[n];
    answer = new double[n];
    once = new double[n];
  }

  /**
   * Returns whether steps of a backward formula can begin beyond the stability of an Adams method.
   *
   * @param slope f at the start; not modified
   * @param change f at the first prediction less {@code slope}; not modified
   * @param h of that prediction
   */
  boolean startsStiff(double t, double[] y, double[] slope, double[] change, double h) {
    double size = norm.of(change);
    boolean fails = 0.5 * Math.abs(h) * size > 1;
    boolean suspicious = fails || size >= SUSPICIOUS * norm.of(slope);
    if (!suspicious || size == 0 || !Double.isFinite(size)) {
      return false;
    }
    differentiate(t, y, slope, change, WAY / size, 0);
    rate = norm.of(answer) / WAY;
    boolean usable = rate > 0 && Double.isFinite(rate);
    if (!usable || rate * Math.abs(h) < STABLE || cosine(change, answer) > GROWS) {
      return false;
    }
    double way = Math.copySign(Math.min(Math.abs(h), SHORT / rate), h);
    differentiate(t, y, slope, slope, way, way);
    double curvature = norm.of(answer) / Math.abs(way);
    return rate * Math.sqrt(2 / curvature) >= STIFF;
  }

  /** Returns the rate of the fastest motion at the start that was looked at. */
  double rate() {
    return rate;
  }

  /**
   * Returns the rate at which an oscillation decays; 0 if the direction is not that of one alone.
   *
   * @param slope f at y; not modified
   * @param direction in which it prevails; not modified
   */
  double decay(double t, double[] y, double[] slope, double[] direction) {
    double size = norm.of(direction);
    if (!(size > 0) || !Double.isFinite(size)) {
      return 0;
    }
    double first = WAY / size;
    differentiate(t, y, slope, direction, first, 0);
    double grown = norm.of(answer);
    if (!(grown > 0) || !Double.isFinite(grown)) {
      return 0;
    }
    System.arraycopy(answer, 0, once, 0, once.length);
    double second = WAY / grown;
    differentiate(t, y, slope, once, second, 0);
    return -0.5 * realSum(first, direction, second);
  }

  /** Fits J² x = p J x + q x and returns p; 0 if that does not hold for a complex pair. */
  private double realSum(double first, double[] x, double second) {
    double xx = 0;
    double xu = 0;
    double uu = 0;
    double xv = 0;
    double uv = 0;
    double vv = 0;
    for (int l = 0; l < x.length; l++) {
      double weight = norm.weight(l);
      double none = weight * first * x[l];
      double u = weight * once[l];
      double v = weight * answer[l] / second;
      xx += none * none;
      xu += none * u;
      uu += u * u;
      xv += none * v;
      uv += u * v;
      vv += v * v;
    }
    double determinant = uu * xx - xu * xu;
    double p = (uv * xx - xv * xu) / determinant;
    double q = (uu * xv - xu * uv) / determinant;
    double left = vv - p * uv - q * xv;
    boolean oscillates = p * p + 4 * q < 0;
    return oscillates && left <= ALONE * ALONE * vv ? p : 0;
  }

  /** Forms the change of f over a way. */
  private void differentiate(
      double t, double[] y, double[] slope, double[] direction, double way, double later) {
    for (int l = 0; l < y.length; l++) {
      moved[l] = y[l] + way * direction[l];
    }
    system.derivative(t + later, moved, answer);
    evaluations++;
    for (int l = 0; l < y.length; l++) {
      answer[l] -= slope[l];
    }
  }

  private double cosine(double[] x1, double[] x2) {
    double product = 0;
    double square1 = 0;
    double square2 = 0;
    for (int l = 0; l < x1.length; l++) {
      double weight = norm.weight(l);
      product += weight * x1[l] * weight * x2[l];
      square1 += weight * x1[l] * weight * x1[l];
      square2 += weight * x2[l] * weight * x2[l];
    }
    return product / (Math.sqrt(square1) * Math.sqrt(square2));
  }

  /** Returns how often f was evaluated. */
  long evaluations() {
    return evaluations;
  }

  /** Carries the count over. */
  void transfer(SavedState state) {
    evaluations = state.integer(evaluations);
  }
}
