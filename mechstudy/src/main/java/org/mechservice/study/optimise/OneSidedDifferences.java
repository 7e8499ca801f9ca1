package org.mechservice.study.optimise;

/**
 * Derivatives by one difference for each variable on the unit cube, away from the nearer bound. The
 * error is half the step times the second derivative: enough on the way to an optimum, at half the
 * cost of {@link CentralDifferences}. Where the function fails to one side the other one is taken;
 * where it fails to both the derivative is taken for zero.
 */
public final class OneSidedDifferences implements Derivatives {
  private final Response function;
  private final double step;

  /**
   * @param function of variables from 0 to 1
   * @param step part of the range, more than 0 and at most 0.1
   */
  public OneSidedDifferences(Response function, double step) {
    this.function = function;
    this.step = CentralDifferences.checked(step);
  }

  @Override
  public double[][] at(double[] point) throws PointFailedException {
    double[] here = function.at(point);
    double[][] derivatives = new double[here.length][point.length];
    for (int j = 0; j < point.length; j++) {
      double inward = point[j] > 0.5 ? -step : step;
      for (double move : new double[] {inward, -inward}) {
        double[] there = CentralDifferences.moved(function, point, j, move);
        if (there.length > 0) {
          for (int i = 0; i < here.length; i++) {
            derivatives[i][j] = (there[i] - here[i]) / move;
          }
          break;
        }
      }
    }
    return derivatives;
  }
}
