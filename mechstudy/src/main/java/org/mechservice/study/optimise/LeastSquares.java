package org.mechservice.study.optimise;

import java.util.Arrays;

/**
 * Least squares on the unit cube: Levenberg-Marquardt with a bound of the steps (Moré 1978), inside
 * the bounds of the variables.
 *
 * <p>Derivatives are computed at accepted points only, and the last ones serve the caller, too. A
 * trial point that cannot be computed is one that is too far.
 *
 * <p>The search ends where a step would lower the sum of squares S by less than 1e-10 of it,
 * foreseen by the linear model, after that step. With m values and n parameters this is a distance
 * from the optimum of √(1e-10 (m − n)) standard deviations before the last step, which squares it.
 * The sums themselves are no measure so close to the end: integrated residuals know S to some 1e-7
 * of it. There steps are accepted as long as what is foreseen becomes less.
 */
public final class LeastSquares {
  private static final int ITERATIONS = 200;

  /** Foreseen part of S below which a step is the last. */
  private static final double LAST = 1e-10;

  /** Foreseen part of S from which derivatives are to be the better ones. */
  private static final double NEAR = 1e-4;

  /** Part of S that its own error may be. */
  private static final double KNOWN = 1e-7;

  /** Part of the foreseen gain that a step must reach, and those that shorten and lengthen. */
  private static final double ACCEPTED = 1e-4;

  private static final double POOR = 0.25;
  private static final double GOOD = 0.75;

  /** Least bound of the first step, in diagonals of the cube: a start at lower bounds is 0. */
  private static final double FIRST = 0.1;

  /** Step, as a part of the point's size, that does not move it. */
  private static final double NO_STEP = 1e-14;

  /**
   * A point with the least sum of squares near a start.
   *
   * @param point of the unit cube
   * @param residuals there
   * @param jacobian their derivatives there, or where the last step began, which is less than
   *     √(1e-10 (m − n)) standard deviations away
   */
  @SuppressWarnings("ArrayRecordComponent") // never compared
  public record Fit(double[] point, double[] residuals, double[][] jacobian) {}

  private final Response residuals;
  private final Derivatives jacobian;
  private final Derivatives rough;

  /**
   * @param residuals on the unit cube
   * @param jacobian their derivatives
   */
  public LeastSquares(Response residuals, Derivatives jacobian) {
    this(residuals, jacobian, jacobian);
  }

  /**
   * @param residuals on the unit cube
   * @param jacobian their derivatives
   * @param rough derivatives that cost less, for as long as the optimum is far
   */
  public LeastSquares(Response residuals, Derivatives jacobian, Derivatives rough) {
    this.residuals = residuals;
    this.jacobian = jacobian;
    this.rough = rough;
  }

  /**
   * Returns the point with the least sum of squares near a start.
   *
   * @param start point of the unit cube; not modified
   * @throws PointFailedException if the residuals cannot be computed at the start, their
   *     derivatives at a point on the way, or no residuals at any point that is tried next
   */
  public Fit minimise(double[] start) throws PointFailedException {
    double[] x = clipped(start, new double[start.length]);
    double[] r = residuals.at(x);
    double sum = squares(r);
    BoundedStep steps = new BoundedStep(x.length);
    boolean near = jacobian == rough;
    double[][] slopes = rough.at(x);
    steps.at(TallFactors.of(slopes, r));
    double radius = Math.max(steps.length(x), FIRST * steps.length(diagonal(x.length)));
    double foreseenBefore = Double.POSITIVE_INFINITY;
    for (int k = 0; k < ITERATIONS && sum > 0; ) {
      double[] p = steps.from(x, radius);
      double length = steps.length(p);
      double gain = steps.gain(p);
      if (!near && gain <= NEAR * sum) {
        near = true;
        slopes = jacobian.at(x);
        steps.at(TallFactors.of(slopes, r));
        continue;
      }
      if (!(gain > 0) || length <= NO_STEP * steps.length(x)) {
        break;
      }
      k++;
      double[] next = clipped(x, p);
      double[] there;
      try {
        there = residuals.at(next);
      } catch (PointFailedException e) {
        radius = 0.25 * Math.min(radius, length);
        if (radius <= NO_STEP * steps.length(x)) {
          throw e;
        }
        continue;
      }
      double sumThere = squares(there);
      double ratio = (sum - sumThere) / gain;
      boolean isLast = gain <= LAST * sum;
      boolean isBelowError =
          gain <= KNOWN * sum && sumThere <= (1 + KNOWN) * sum && gain < 0.5 * foreseenBefore;
      if (ratio > ACCEPTED || isBelowError) {
        x = next;
        r = there;
        sum = sumThere;
        foreseenBefore = gain;
      }
      if (isLast) {
        break;
      }
      if (ratio > ACCEPTED || isBelowError) {
        slopes = (near ? jacobian : rough).at(x);
        steps.at(TallFactors.of(slopes, r));
      } else if (gain <= KNOWN * sum) {
        break; // the precision of the residuals allows no further progress
      }
      if (!(ratio >= POOR)) {
        radius = shortened(ratio) * Math.min(radius, length);
      } else if (ratio > GOOD) {
        radius = Math.max(radius, 2 * length);
      }
    }
    return new Fit(x, r, slopes);
  }

  /**
   * Returns the part of a step, 0.1 to 0.5, at which the parabola is least that leaves with twice
   * the foreseen gain, as after a step without damping, and ends as the step did.
   */
  private static double shortened(double ratio) {
    double part = 1 / (2 - ratio);
    return part > 0.1 ? Math.min(part, 0.5) : 0.1;
  }

  private static double[] diagonal(int n) {
    double[] ones = new double[n];
    Arrays.fill(ones, 1);
    return ones;
  }

  private static double[] clipped(double[] x, double[] p) {
    double[] moved = new double[x.length];
    for (int j = 0; j < moved.length; j++) {
      moved[j] = Math.max(0, Math.min(1, x[j] + p[j]));
    }
    return moved;
  }

  private static double squares(double[] r) {
    double sum = 0;
    for (double each : r) {
      sum += each * each;
    }
    return sum;
  }
}
