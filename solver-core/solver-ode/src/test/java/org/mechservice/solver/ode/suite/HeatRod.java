package org.mechservice.solver.ode.suite;

import org.mechservice.solver.ode.BandedSystem;
import org.mechservice.solver.ode.OdeSystem;

/**
 * Heat that spreads along a rod with cold ends, by differences at n points inside of it: y_i' = (n
 * + 1)² (y_{i−1} − 2 y_i + y_{i+1}). Three diagonals, declared as {@link Banded} tells.
 *
 * @param dimension number of points, n
 */
public record HeatRod(int dimension) implements OdeSystem, BandedSystem {
  @Override
  public int lowerBandwidth() {
    return 1;
  }

  @Override
  public int upperBandwidth() {
    return 1;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    int n = dimension;
    double conduction = (n + 1.0) * (n + 1.0);
    for (int i = 0; i < n; i++) {
      double before = i == 0 ? 0 : y[i - 1];
      double after = i == n - 1 ? 0 : y[i + 1];
      yDot[i] = conduction * (before - 2 * y[i] + after);
    }
  }

  /** Returns the same rod without its band. */
  public OdeSystem undeclared() {
    return new FunctionOde(dimension, this::derivative);
  }

  /** Returns the first two waves that fit the rod; they decay at rates near π² and 4π². */
  public double[] initialState() {
    double[] y = new double[dimension];
    for (int i = 0; i < dimension; i++) {
      double x = (i + 1.0) / (dimension + 1);
      y[i] = StrictMath.sin(Math.PI * x) + 0.5 * StrictMath.sin(2 * Math.PI * x);
    }
    return y;
  }

  /** Returns what is left of them, exactly but for rounding. */
  public double[] at(double t) {
    double[] y = new double[dimension];
    for (int i = 0; i < dimension; i++) {
      double x = (i + 1.0) / (dimension + 1);
      y[i] = wave(1, x, t) + 0.5 * wave(2, x, t);
    }
    return y;
  }

  private double wave(int m, double x, double t) {
    double half = StrictMath.sin(0.5 * m * Math.PI / (dimension + 1));
    double rate = 4 * (dimension + 1.0) * (dimension + 1.0) * half * half;
    return StrictMath.exp(-rate * t) * StrictMath.sin(m * Math.PI * x);
  }
}
