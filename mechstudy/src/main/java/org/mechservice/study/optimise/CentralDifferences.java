package org.mechservice.study.optimise;

/**
 * Derivatives by differences on the unit cube: central ones of second order, one-sided ones of
 * second order at a bound. Where the function fails on one side the difference to the other side is
 * taken; where it fails on both sides the derivative is taken for zero.
 *
 * <p>The step is a part of the variables' ranges. Its best size is the cube root of the functions'
 * relative noise: for runs with relative tolerances of 1e-9 about 1e-3, for formulas 1e-5.
 */
public final class CentralDifferences implements Derivatives {
  private final Response function;
  private final double step;

  /**
   * @param function of variables from 0 to 1
   * @param step part of the range, more than 0 and at most 0.1
   */
  public CentralDifferences(Response function, double step) {
    this.function = function;
    this.step = checked(step);
  }

  /** Returns a step that is a part of a range. */
  static double checked(double step) {
    if (!(step > 0 && step <= 0.1)) {
      throw new IllegalArgumentException(
          "the step of differences is " + step + "; it must be more than 0 and at most 0.1");
    }
    return step;
  }

  @Override
  public double[][] at(double[] point) throws PointFailedException {
    double[] middle = function.at(point);
    double[][] derivatives = new double[middle.length][point.length];
    for (int j = 0; j < point.length; j++) {
      double[] column = column(point, j, middle);
      for (int i = 0; i < middle.length; i++) {
        derivatives[i][j] = column[i];
      }
    }
    return derivatives;
  }

  private double[] column(double[] point, int j, double[] middle) {
    double[] up = moved(function, point, j, step);
    double[] down = moved(function, point, j, -step);
    if (up.length > 0 && down.length > 0) {
      return combined(up, 0.5 / step, down, -0.5 / step, middle, 0);
    } else if (up.length > 0) {
      double[] further = moved(function, point, j, 2 * step);
      return further.length > 0
          ? combined(up, 2 / step, further, -0.5 / step, middle, -1.5 / step)
          : combined(up, 1 / step, middle, -1 / step, middle, 0);
    } else if (down.length > 0) {
      double[] further = moved(function, point, j, -2 * step);
      return further.length > 0
          ? combined(down, -2 / step, further, 0.5 / step, middle, 1.5 / step)
          : combined(down, -1 / step, middle, 1 / step, middle, 0);
    }
    return new double[middle.length];
  }

  /** Returns the values at a neighbour, or none if it is outside the bounds or fails. */
  static double[] moved(Response function, double[] point, int j, double by) {
    double[] other = point.clone();
    other[j] += by;
    if (other[j] < 0 || other[j] > 1) {
      return new double[0];
    }
    try {
      return function.at(other);
    } catch (PointFailedException e) {
      return new double[0];
    }
  }

  private static double[] combined(
      double[] a, double factorA, double[] b, double factorB, double[] c, double factorC) {
    double[] sum = new double[a.length];
    for (int i = 0; i < sum.length; i++) {
      sum[i] = factorA * a[i] + factorB * b[i] + factorC * c[i];
    }
    return sum;
  }
}
