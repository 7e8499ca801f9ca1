package org.mechservice.study.identify;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.mechservice.study.optimise.CentralDifferences;
import org.mechservice.study.optimise.Derivatives;
import org.mechservice.study.optimise.LeastSquares;
import org.mechservice.study.optimise.OneSidedDifferences;
import org.mechservice.study.optimise.PointFailedException;
import org.mechservice.study.optimise.Response;

/**
 * Weighted residuals as a function on the unit cube of the fitted variables. The latest point is
 * remembered, since a fit and differences of residuals ask for it in turn. Workspace of one fit.
 */
final class CubeResiduals implements Response {
  private final UnaryOperator<double[]> points;
  private final Response residuals;
  private double[] latest = {};
  private double[] value = {};
  private int runs;

  /**
   * @param points from the cube to the units of the parameters
   * @param residuals of points in these units
   */
  CubeResiduals(UnaryOperator<double[]> points, Response residuals) {
    this.points = points;
    this.residuals = residuals;
  }

  @Override
  public double[] at(double[] parts) throws PointFailedException {
    if (value.length == 0 || !Arrays.equals(latest, parts)) {
      runs++;
      value = residuals.at(points.apply(parts));
      latest = parts.clone();
    }
    return value;
  }

  /** Returns how many points were computed. */
  int runs() {
    return runs;
  }

  /**
   * Fits: with derivatives, or with differences, which are one-sided until the optimum is near.
   *
   * @param slopes derivatives by the units of the cube, if there are any
   * @param step of differences, as a part of the ranges
   */
  LeastSquares.Fit fitted(double[] start, Optional<Derivatives> slopes, double step)
      throws PointFailedException {
    LeastSquares search =
        slopes.isPresent()
            ? new LeastSquares(this, slopes.get())
            : new LeastSquares(
                this, new CentralDifferences(this, step), new OneSidedDifferences(this, step));
    return search.minimise(start);
  }
}
