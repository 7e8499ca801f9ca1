package org.mechservice.benchmarks.study;

import org.mechservice.solver.ode.OdeSystem;

/** x'' = −ω² x as a system of two equations scaled to equal size: y' = ω (y₁, −y₀). */
record Oscillator(double omega) implements OdeSystem {
  @Override
  public int dimension() {
    return 2;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    yDot[0] = omega * y[1];
    yDot[1] = -omega * y[0];
  }
}
