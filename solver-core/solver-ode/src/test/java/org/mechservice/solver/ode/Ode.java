package org.mechservice.solver.ode;

/** An initial value problem written down in a test. */
record Ode(int dimension, Equation equation) implements OdeSystem {
  /** y' = f(t, y). */
  interface Equation {
    void evaluate(double t, double[] y, double[] yDot);
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    equation.evaluate(t, y, yDot);
  }
}
