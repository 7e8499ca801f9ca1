package org.mechservice.study.optimise;

import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.analysis.MultivariateMatrixFunction;
import org.apache.commons.math3.analysis.MultivariateVectorFunction;
import org.apache.commons.math3.exception.ConvergenceException;
import org.apache.commons.math3.exception.TooManyEvaluationsException;
import org.apache.commons.math3.exception.TooManyIterationsException;
import org.apache.commons.math3.fitting.leastsquares.LeastSquaresBuilder;
import org.apache.commons.math3.fitting.leastsquares.LeastSquaresOptimizer.Optimum;
import org.apache.commons.math3.fitting.leastsquares.LevenbergMarquardtOptimizer;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealVector;

/**
 * Least squares on the unit cube: Levenberg-Marquardt (Commons Math), with the steps clipped at the
 * bounds. A variable that a fit presses against its bound is held there, and the fit is repeated
 * over the others.
 */
public final class LeastSquares {
  private static final int ITERATIONS = 200;
  private static final double TOLERANCE = 1e-12;

  /** A residual that cannot be computed, inside the library's functions. */
  private static final class Failed extends RuntimeException {
    private static final long serialVersionUID = 1L;

    Failed(PointFailedException cause) {
      super(cause.getMessage(), cause);
    }
  }

  private final Response residuals;
  private final Derivatives jacobian;

  /**
   * @param residuals on the unit cube
   * @param jacobian their derivatives
   */
  public LeastSquares(Response residuals, Derivatives jacobian) {
    this.residuals = residuals;
    this.jacobian = jacobian;
  }

  /**
   * Returns the point with the least sum of squares near a start.
   *
   * @param start point of the unit cube; not modified
   * @throws PointFailedException if the residuals cannot be computed at a point on the way
   */
  public double[] minimise(double[] start) throws PointFailedException {
    double[] point = start.clone();
    List<Integer> free = new ArrayList<>();
    for (int j = 0; j < point.length; j++) {
      free.add(j);
    }
    try {
      while (!free.isEmpty()) {
        point = fit(point, free);
        List<Integer> pressed = pressed(point, free);
        if (pressed.isEmpty()) {
          break;
        }
        free.removeAll(pressed);
      }
      return point;
    } catch (Failed e) {
      throw new PointFailedException(String.valueOf(e.getMessage()));
    }
  }

  private double[] fit(double[] from, List<Integer> free) {
    double[] best = from.clone();
    double[] least = {Double.POSITIVE_INFINITY};
    MultivariateVectorFunction value =
        x -> {
          try {
            double[] point = whole(from, free, x);
            double[] r = residuals.at(point);
            double sum = squares(r);
            if (sum < least[0]) {
              least[0] = sum;
              System.arraycopy(point, 0, best, 0, point.length);
            }
            return r;
          } catch (PointFailedException e) {
            throw new Failed(e);
          }
        };
    MultivariateMatrixFunction derivative =
        x -> {
          try {
            return columns(jacobian.at(whole(from, free, x)), free);
          } catch (PointFailedException e) {
            throw new Failed(e);
          }
        };
    double[] start = free.stream().mapToDouble(j -> from[j]).toArray();
    try {
      Optimum optimum =
          new LevenbergMarquardtOptimizer()
              .withCostRelativeTolerance(TOLERANCE)
              .withParameterRelativeTolerance(TOLERANCE)
              .withInitialStepBoundFactor(1)
              .optimize(
                  new LeastSquaresBuilder()
                      .start(start)
                      .model(value, derivative)
                      .target(new double[value.value(start).length])
                      .parameterValidator(LeastSquares::clipped)
                      .maxEvaluations(Integer.MAX_VALUE)
                      .maxIterations(ITERATIONS)
                      .build());
      return whole(from, free, optimum.getPoint().toArray());
    } catch (ConvergenceException | TooManyIterationsException | TooManyEvaluationsException e) {
      // The precision of the residuals allows no further progress.
      return best;
    }
  }

  private static double squares(double[] r) {
    double sum = 0;
    for (double each : r) {
      sum += each * each;
    }
    return sum;
  }

  private static RealVector clipped(RealVector point) {
    double[] clipped = point.toArray();
    for (int j = 0; j < clipped.length; j++) {
      clipped[j] = Math.max(0, Math.min(1, clipped[j]));
    }
    return new ArrayRealVector(clipped, false);
  }

  private static double[] whole(double[] from, List<Integer> free, double[] x) {
    double[] point = from.clone();
    for (int k = 0; k < x.length; k++) {
      point[free.get(k)] = Math.max(0, Math.min(1, x[k]));
    }
    return point;
  }

  private static double[][] columns(double[][] matrix, List<Integer> free) {
    double[][] part = new double[matrix.length][free.size()];
    for (int i = 0; i < matrix.length; i++) {
      for (int k = 0; k < free.size(); k++) {
        part[i][k] = matrix[i][free.get(k)];
      }
    }
    return part;
  }

  /** Returns the free variables at a bound beyond which the sum of squares would be smaller. */
  private List<Integer> pressed(double[] point, List<Integer> free) throws PointFailedException {
    List<Integer> atBound = free.stream().filter(j -> point[j] == 0 || point[j] == 1).toList();
    if (atBound.isEmpty()) {
      return atBound;
    }
    double[] r = residuals.at(point);
    double[][] derivatives = jacobian.at(point);
    List<Integer> pressed = new ArrayList<>();
    for (int j : atBound) {
      double slope = 0;
      for (int i = 0; i < r.length; i++) {
        slope += r[i] * derivatives[i][j];
      }
      if (point[j] == 0 ? slope > 0 : slope < 0) {
        pressed.add(j);
      }
    }
    return pressed;
  }
}
