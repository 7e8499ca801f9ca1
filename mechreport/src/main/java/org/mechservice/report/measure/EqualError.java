package org.mechservice.report.measure;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import org.apache.commons.math3.stat.regression.SimpleRegression;

/** Cost of a method at a given error, between its points. */
public final class EqualError {
  private EqualError() {}

  /**
   * Returns the least cost of an error.
   *
   * @param points of one method, loosest tolerance first
   * @param error to be reached
   * @param cost of a point, positive; points whose cost is not a number do not count
   * @return interpolated between points in logarithms; that of the cheapest point where all are
   *     better; empty if the error is not reached
   */
  public static OptionalDouble cost(
      List<Point> points, double error, ToDoubleFunction<Point> cost) {
    List<Point> usable =
        points.stream()
            .filter(point -> point.completed() && cost.applyAsDouble(point) > 0)
            .filter(point -> Double.isFinite(point.error()))
            .toList();
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < usable.size(); i++) {
      Point point = usable.get(i);
      if (point.error() <= error) {
        boolean crosses = i > 0 && usable.get(i - 1).error() > error;
        least =
            Math.min(
                least,
                crosses
                    ? between(usable.get(i - 1), point, error, cost)
                    : cost.applyAsDouble(point));
      }
    }
    return least < Double.POSITIVE_INFINITY ? OptionalDouble.of(least) : OptionalDouble.empty();
  }

  private static double between(
      Point worse, Point better, double error, ToDoubleFunction<Point> cost) {
    return between(
        worse.error(),
        cost.applyAsDouble(worse),
        Math.max(better.error(), Double.MIN_NORMAL),
        cost.applyAsDouble(better),
        error);
  }

  /**
   * Returns the cost of an error between two, interpolated in logarithms.
   *
   * @param worse larger error
   * @param costOfWorse its cost
   * @param better smaller error
   * @param costOfBetter its cost
   * @param error between them
   */
  public static double between(
      double worse, double costOfWorse, double better, double costOfBetter, double error) {
    double part = Math.log(worse / error) / Math.log(worse / better);
    return Math.exp(Math.log(costOfWorse) + part * Math.log(costOfBetter / costOfWorse));
  }

  /**
   * Returns the order observed: how fast the error falls with the number of steps, by least squares
   * in logarithms.
   *
   * @param floor errors below ten times this do not count
   * @return empty if fewer than two points are left
   */
  public static OptionalDouble order(List<Point> points, double floor) {
    List<Point> usable =
        points.stream()
            .filter(point -> point.completed() && point.error() > 10 * floor)
            .filter(point -> point.error() < 1 && point.first().steps() > 0)
            .toList();
    if (usable.size() < 2) {
      return OptionalDouble.empty();
    }
    double[] steps =
        usable.stream().mapToDouble(p -> Math.log((double) p.first().steps())).toArray();
    double[] errors = usable.stream().mapToDouble(p -> Math.log(p.error())).toArray();
    double slope = slope(steps, errors);
    return Double.isNaN(slope) ? OptionalDouble.empty() : OptionalDouble.of(-slope);
  }

  /**
   * Returns the slope of a straight line through points, by least squares.
   *
   * @param x at least two
   * @param y as many
   * @return NaN if all x are equal
   */
  public static double slope(double[] x, double[] y) {
    SimpleRegression line = new SimpleRegression();
    for (int i = 0; i < x.length; i++) {
      line.addData(x[i], y[i]);
    }
    return line.getSlope();
  }
}
