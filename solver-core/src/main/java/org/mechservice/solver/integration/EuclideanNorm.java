package org.mechservice.solver.integration;

/**
 * Norm of DE: the root of the sum of squares, the error allowed is rtol |y_i| + atol_i. Shampine
 * and Gordon 1975.
 */
final class EuclideanNorm implements ErrorNorm {
  private double relativeTolerance;
  private double[] absoluteTolerance = {};
  private double[] weight = {};

  @Override
  public void begin(double relativeTolerance, double[] absoluteTolerance) {
    this.relativeTolerance = relativeTolerance;
    this.absoluteTolerance = absoluteTolerance;
    weight = new double[absoluteTolerance.length];
  }

  @Override
  public void weigh(double[] y) {
    for (int l = 0; l < weight.length; l++) {
      weight[l] = 1 / (relativeTolerance * Math.abs(y[l]) + absoluteTolerance[l]);
    }
  }

  @Override
  public void leaveOut(int component) {
    weight[component] = 0;
  }

  @Override
  public double of(double[] x) {
    double sum = 0;
    for (int l = 0; l < weight.length; l++) {
      double part = x[l] * weight[l];
      sum += part * part;
    }
    return Math.sqrt(sum);
  }

  @Override
  public double ofSum(double[] x1, double[] x2) {
    double sum = 0;
    for (int l = 0; l < weight.length; l++) {
      double part = (x1[l] + x2[l]) * weight[l];
      sum += part * part;
    }
    return Math.sqrt(sum);
  }

  @Override
  public double weight(int component) {
    return weight[component];
  }
}
