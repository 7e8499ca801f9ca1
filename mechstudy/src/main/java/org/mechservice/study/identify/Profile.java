package org.mechservice.study.identify;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.TDistribution;
import org.mechservice.study.optimise.Derivatives;
import org.mechservice.study.optimise.DesignVariable;
import org.mechservice.study.optimise.PointFailedException;
import org.mechservice.study.optimise.Response;

/**
 * The likelihood profile of one parameter, without linearisation of the model: the parameter is
 * held at values beside the found one, and the others are fitted anew (Bates and Watts 1988, §6.1).
 * With the sum S of the squares, τ = ±√(S − S_min) / s; where the model is linear in its
 * parameters, τ is a straight line over the parameter and counts standard deviations. The interval
 * ends where |τ| is the quantile of Student's t.
 *
 * @param variable which parameter
 * @param points parameter and τ, ascending; among them the found value with 0
 * @param lower where the interval begins; empty if the parameter may go to its bound
 * @param upper where it ends; empty likewise
 * @param runs computed points
 */
public record Profile(
    int variable, List<double[]> points, Optional<Double> lower, Optional<Double> upper, int runs) {
  /** Steps from the found value to the quantile. */
  private static final int STEPS = 4;

  /** Steps in all to one side; a profile that is much flatter than the deviation ends there. */
  private static final int MOST = 12;

  public Profile {
    points = List.copyOf(points);
  }

  /**
   * Computes the profile of a parameter.
   *
   * @param found the fit
   * @param variable a parameter of it
   * @param response weighted residuals, as in the fit
   * @param step of differences, as a part of the ranges, where there are no derivatives
   * @param slopes derivatives of the residuals; empty for differences
   * @param level of the interval, such as 0.95
   * @throws PointFailedException if a point on the way cannot be computed
   */
  public static Profile of(
      Identification found,
      int variable,
      Response response,
      double step,
      Optional<Derivatives> slopes,
      double level)
      throws PointFailedException {
    return new Search(found, variable, response, step, slopes, level).profile();
  }

  /** The fits of one profile. */
  private static final class Search {
    private final Identification found;
    private final int variable;
    private final Response response;
    private final double step;
    private final Optional<Derivatives> slopes;
    private final double quantile;
    private final double least;
    private final int[] others;
    private int runs;

    Search(
        Identification found,
        int variable,
        Response response,
        double step,
        Optional<Derivatives> slopes,
        double level) {
      this.found = found;
      this.variable = variable;
      this.response = response;
      this.step = step;
      this.slopes = slopes;
      quantile = new TDistribution(found.freedom()).inverseCumulativeProbability(0.5 + level / 2);
      least = squares(found.residuals());
      others = IntStream.range(0, found.values().length).filter(j -> j != variable).toArray();
    }

    Profile profile() throws PointFailedException {
      List<double[]> points = new ArrayList<>();
      points.add(new double[] {found.values()[variable], 0});
      Optional<Double> lower = side(-1, points);
      Optional<Double> upper = side(1, points);
      points.sort(Comparator.comparingDouble(point -> point[0]));
      return new Profile(variable, points, lower, upper, runs);
    }

    /** Goes to one side as far as the quantile, and returns where it is. */
    private Optional<Double> side(int sign, List<double[]> points) throws PointFailedException {
      DesignVariable own = found.variables().get(variable);
      double range = own.upper() - own.lower();
      double deviation = found.deviations()[variable];
      double stride = sign * Math.min(quantile * deviation / STEPS, range / STEPS);
      double[] parts = new double[others.length];
      for (int k = 0; k < parts.length; k++) {
        parts[k] = found.variables().get(others[k]).part(found.values()[others[k]]);
      }
      double[] before = points.get(0);
      for (int k = 1; k <= MOST; k++) {
        double value = found.values()[variable] + k * stride;
        boolean atBound = value <= own.lower() || value >= own.upper();
        value = Math.max(own.lower(), Math.min(own.upper(), value));
        if (value == before[0]) {
          return Optional.empty();
        }
        parts = fitted(value, parts);
        double more = Math.max(0, squares(at(value, parts)) - least);
        double[] point = {value, sign * Math.sqrt(more) / found.noise()};
        points.add(point);
        if (Math.abs(point[1]) >= quantile) {
          double part = (sign * quantile - before[1]) / (point[1] - before[1]);
          return Optional.of(before[0] + part * (point[0] - before[0]));
        } else if (atBound) {
          return Optional.empty();
        }
        before = point;
      }
      return Optional.empty();
    }

    /** Fits the other parameters, on the unit cube. */
    private double[] fitted(double value, double[] from) throws PointFailedException {
      if (others.length == 0) {
        return from;
      }
      CubeResiduals onCube = new CubeResiduals(parts -> point(value, parts), response);
      double[] parts =
          onCube
              .fitted(from, slopes.map(by -> at -> columns(by.at(point(value, at)))), step)
              .point();
      runs += onCube.runs();
      return parts;
    }

    private double[] at(double value, double[] parts) throws PointFailedException {
      runs++;
      return response.at(point(value, parts));
    }

    private double[] point(double value, double[] parts) {
      double[] point = new double[found.values().length];
      point[variable] = value;
      for (int k = 0; k < others.length; k++) {
        point[others[k]] = found.variables().get(others[k]).value(parts[k]);
      }
      return point;
    }

    private double[][] columns(double[][] jacobian) {
      double[][] part = new double[jacobian.length][others.length];
      for (int i = 0; i < part.length; i++) {
        for (int k = 0; k < others.length; k++) {
          DesignVariable other = found.variables().get(others[k]);
          part[i][k] = jacobian[i][others[k]] * (other.upper() - other.lower());
        }
      }
      return part;
    }

    private static double squares(double[] r) {
      double sum = 0;
      for (double each : r) {
        sum += each * each;
      }
      return sum;
    }
  }
}
