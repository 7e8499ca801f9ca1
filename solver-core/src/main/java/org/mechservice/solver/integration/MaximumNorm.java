package org.mechservice.solver.integration;

/**
 * Norm of ode113 and ode15s: the largest component counts, the error allowed is max(rtol |y_i|,
 * atol_i). Shampine and Reichelt 1997.
 */
final class MaximumNorm implements ErrorNorm {
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
      weight[l] = 1 / Math.max(relativeTolerance * Math.abs(y[l]), absoluteTolerance[l]);
    }
  }

  /**
   * Sets the error allowed in each component by the larger of two states.
   *
   * @param y1 not modified
   * @param y2 not modified
   */
  void weigh(double[] y1, double[] y2) {
    for (int l = 0; l < weight.length; l++) {
      double size = Math.max(Math.abs(y1[l]), Math.abs(y2[l]));
      weight[l] = 1 / Math.max(relativeTolerance * size, absoluteTolerance[l]);
    }
  }

  @Override
  public void leaveOut(int component) {
    weight[component] = 0;
  }

  @Override
  public double of(double[] x) {
    double norm = 0;
    for (int l = 0; l < weight.length; l++) {
      norm = Math.max(norm, Math.abs(x[l]) * weight[l]);
    }
    return norm;
  }

  @Override
  public double ofSum(double[] x1, double[] x2) {
    double norm = 0;
    for (int l = 0; l < weight.length; l++) {
      norm = Math.max(norm, Math.abs(x1[l] + x2[l]) * weight[l]);
    }
    return norm;
  }

  @Override
  public double weight(int component) {
    return weight[component];
  }
}
