package org.mechservice.solver.ode.suite;

import org.mechservice.solver.ode.OdeSystem;

/** An initial value problem written down in a test. */
public record FunctionOde(int dimension, Equation equation) implements OdeSystem {
  /** y' = f(t, y). */
  public interface Equation {
    void evaluate(double t, double[] y, double[] yDot);
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    equation.evaluate(t, y, yDot);
  }
}
