package org.mechservice.solver.ode;

/** A problem in residual form written down in a test. */
class Implicit implements ResidualSystem {
  /** F(t, y, y'). */
  interface Equation {
    void evaluate(double t, double[] y, double[] yDot, double[] residual);
  }

  private final int dimension;
  private final Equation equation;

  Implicit(int dimension, Equation equation) {
    this.dimension = dimension;
    this.equation = equation;
  }

  @Override
  public int dimension() {
    return dimension;
  }

  @Override
  public void residual(double t, double[] y, double[] yDot, double[] residual) {
    equation.evaluate(t, y, yDot, residual);
  }
}
